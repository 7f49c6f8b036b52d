// The hot loop: the contact law over all lanes, and the sums over clumps. It goes in stages over a
// few blocks of lanes at a time, which pass through the nearest cache: where the spheres are, in
// quads of lanes out of the records of the clumps; the law, in bundles of registers; the sums, lane
// by lane. Each stage has a rhythm of its own, so together they would get in each other's way
// (docs/performance.md).
//
// Contact points and moments are about the world's origin, so that both clumps share them; the
// torque about a clump's centre of mass is made once a clump (body_records.h).
//
// The fourth number of the quads that are summed is energy: what a contact loses in this step to
// friction goes with its force and what it loses to damping with its moment, so that a clump's sums
// as first body hold it with a positive sign and the others with a negative one. It counts twice at
// walls, since half of it is booked to each clump (BodySums::write). What crushing takes, which few
// laws know, goes in sums of its own.
#include "dem/bodies/wide.h"
#include "dem/exact_sums.h"
#include "dem/input_error.h"
#include "dem/lanes/contact_lanes.h"
#include "dem/lanes/lane_geometry.h"

#include <numeric>

namespace interlock::dem
{
namespace
{
using Row = LaneBlock::Row;

// What the law adds to the sums besides the force.
struct alignas(64) LaneMoments {
  Row moment[3];         // of the force, about the origin [N m]
  Row friction, damping; // lost in this step [J]
  Row crushing;          // likewise, of laws that crush
};

constexpr int blocks_at_a_time = 4;

// From lane l on.
INTERLOCK_LANE LaneVector<Wide> load(const Row (&rows)[3], int l)
{
  return {Wide::load(rows[0] + l), Wide::load(rows[1] + l), Wide::load(rows[2] + l)};
}
INTERLOCK_LANE void store(Row (&rows)[3], int l, LaneVector<Wide> a)
{
  a.x.store(rows[0] + l), a.y.store(rows[1] + l), a.z.store(rows[2] + l);
}

struct Contact {
  Wide overlap; // negative for a gap [m]
  LaneVector<Wide> normal, point;
};

INTERLOCK_LANE Contact contact_of(const LaneBlock& block, const LaneGeometry& geometry, int l)
{
  const LaneVector<Wide> d = load(geometry.between, l);
  const Wide distance = square_root(dot(d, d) + 1e-300), radius1 = Wide::load(block.radius1 + l);
  Contact contact;
  contact.overlap = (radius1 + Wide::load(block.radius2 + l)) - distance;
  contact.normal = (1 / distance) * d;
  // In the middle of the overlap.
  contact.point = load(geometry.centre, l) - (radius1 - 0.5 * contact.overlap) * contact.normal;
  return contact;
}

template <bool shared, class Law>
INTERLOCK_LANE void apply_law(const Law& law, double dt, const LaneGeometry& geometry, int l,
                              LaneBlock& block, LaneMoments& out)
{
  constexpr bool stiffness_changes = shared || Law::stiffness_changes;
  const Contact contact = contact_of(block, geometry, l);
  const LaneVector<Wide> relative =
      load(geometry.velocity, l) + cross(load(geometry.spin_difference, l), contact.point);
  const LaneVector<Wide> turn = 0.5 * dt * load(geometry.spin_sum, l);

  ConstantsOf<Wide> constants{Wide::load(block.reduced_mass + l), Wide::load(block.root_mass + l),
                              0};
  HistoryOf<Wide> history{load(block.spring, l), load(block.dashpot, l),
                          Wide::load(block.overlap + l), 0};
  if constexpr (stiffness_changes) {
    constants.reduced_radius = Wide::load(block.reduced_radius + l);
    history.tangential_stiffness = Wide::load(block.tangential_stiffness + l);
  }
  if constexpr (Law::crushes) {
    constants.reduced_radius = Wide::load(block.reduced_radius + l);
    history.crushed = Wide::load(block.crushed + l);
  }
  ShareOf<Wide> share;
  if constexpr (shared)
    share = {Wide::load(block.shared_depth + l), Wide::load(block.gradient + l)};
  EnergyOf<Wide> energy;
  const LaneVector<Wide> force = contact_force<shared>(
      law, constants, contact.overlap, contact.normal, relative, turn, share, dt, history, energy);
  store(block.spring, l, history.spring);
  store(block.dashpot, l, history.dashpot);
  history.overlap.store(block.overlap + l);
  // A constant one stands there since the lanes were made (Engine::compute_forces).
  if constexpr (stiffness_changes)
    history.tangential_stiffness.store(block.tangential_stiffness + l);
  store(block.force, l, force);
  store(out.moment, l, cross(contact.point, force));
  energy.friction.store(out.friction + l);
  energy.damping.store(out.damping + l);
  if constexpr (Law::crushes) {
    history.crushed.store(block.crushed + l);
    energy.crushing.store(out.crushing + l);
  }
}

// The quads of lanes l to l + 3 that are summed.
struct Wrenches {
  INTERLOCK_LANE Wrenches(const LaneBlock& block, const LaneMoments& moments, int l)
      : force(lanes_to_quads(block.force[0] + l, block.force[1] + l, block.force[2] + l,
                             moments.friction + l)),
        moment(lanes_to_quads(moments.moment[0] + l, moments.moment[1] + l, moments.moment[2] + l,
                              moments.damping + l))
  {
  }
  std::array<Quad, 4> force, moment;
};

INTERLOCK_LANE Quad kept_where(std::int64_t bits, Quad a)
{
  using Bits = std::int64_t __attribute__((vector_size(32)));
  return reinterpret_cast<Quad>(reinterpret_cast<Bits>(a) & Bits{bits, bits, bits, bits});
}

// Sum over several lanes, energies in the fourth numbers.
struct WrenchSum {
  Quad force{}, moment{};
};

// `run`: the sum over the run of lanes with the same first clump, so far.
INTERLOCK_LANE void add_pairs(const LaneBlock& block, const LaneMoments& moments, WrenchSum& run,
                              BodySums::Sum* sums)
{
  for (int l = 0; l < lane_width; l += 4) {
    const Wrenches w(block, moments, l);
    for (int k = 0; k < 4; ++k) {
      const std::int64_t same = block.same_first[l + k];
      run.force = kept_where(same, run.force) + w.force[k];
      run.moment = kept_where(same, run.moment) + w.moment[k];
      BodySums::Sum &first = sums[block.i[l + k]], &second = sums[block.j[l + k]];
      first.first_force = run.force;
      first.first_moment = run.moment;
      second.other_force -= w.force[k];
      second.other_moment -= w.moment[k];
    }
  }
}

// `force_on_stones`: exact sums, in whichever lane.
INTERLOCK_LANE void add_at_wall(const LaneBlock& block, const LaneMoments& moments,
                                LaneVector<Wide>& force_on_stones, BodySums::Sum* sums)
{
  for (int l = 0; l < lane_width; l += Wide::lanes) {
    const LaneVector<Wide> force = load(block.force, l);
    force_on_stones.x = force_on_stones.x + on_grid<force_grid>(force.x);
    force_on_stones.y = force_on_stones.y + on_grid<force_grid>(force.y);
    force_on_stones.z = force_on_stones.z + on_grid<force_grid>(force.z);
  }
  constexpr Quad with_energy{1, 1, 1, -2};
  for (int l = 0; l < lane_width; l += 4) {
    const Wrenches w(block, moments, l);
    for (int k = 0; k < 4; ++k) {
      BodySums::Sum& sum = sums[block.i[l + k]];
      sum.other_force += with_energy * w.force[k];
      sum.other_moment += with_energy * w.moment[k];
    }
  }
}

// Half of what each contact crushed to each of its clumps, in list order.
INTERLOCK_LANE void add_crushing_of_pairs(const LaneBlock& block, const LaneMoments& moments,
                                          double* crushing)
{
  for (int l = 0; l < lane_width; ++l) {
    crushing[block.i[l]] += 0.5 * moments.crushing[l];
    crushing[block.j[l]] += 0.5 * moments.crushing[l];
  }
}
INTERLOCK_LANE void add_crushing_at_wall(const LaneBlock& block, const LaneMoments& moments,
                                         double* crushing)
{
  for (int l = 0; l < lane_width; ++l) crushing[block.i[l]] += moments.crushing[l];
}

// Calls f with the law that the properties name.
template <class Function> void with_law(const ContactProperties& pair, const Function& f)
{
  using Shared = std::true_type;
  using Plain = std::false_type;
  const bool shared = pair.share_among_contacts;
  if (pair.crushing_pressure > 0) {
    if (shared)
      throw InputError("Contacts have a crushing pressure and share among contacts, but a shared "
                       "contact cannot crush.");
    if (pair.model == ContactModel::linear)
      f(Plain(), Crushing<LinearLaw>(pair));
    else
      f(Plain(), Crushing<HertzMindlinLaw>(pair));
    return;
  }
  if (pair.model == ContactModel::linear && !shared) f(Plain(), LinearLaw(pair));
  if (pair.model == ContactModel::linear && shared) f(Shared(), LinearLaw(pair));
  if (pair.model == ContactModel::hertz_mindlin && !shared) f(Plain(), HertzMindlinLaw(pair));
  if (pair.model == ContactModel::hertz_mindlin && shared) f(Shared(), HertzMindlinLaw(pair));
}

// Runs all blocks through place(block, geometry), the law and add(block, moments).
template <bool shared, class Law, class Place, class Add>
INTERLOCK_LANE void run_stages(const Law& law_of_pair, double dt, LaneBlock* blocks, int n,
                               const Place& place, const Add& add)
{
  const Law law = law_of_pair;
  LaneGeometry geometry[blocks_at_a_time];
  LaneMoments moments[blocks_at_a_time];
  for (int begin = 0; begin < n; begin += blocks_at_a_time) {
    const int m = std::min(blocks_at_a_time, n - begin);
    LaneBlock* now = blocks + begin;
    for (int b = 0; b < m; ++b) place(now[b], geometry[b]);
    for (int b = 0; b < m; ++b)
      for (int l = 0; l < lane_width; l += Wide::lanes)
        apply_law<shared>(law, dt, geometry[b], l, now[b], moments[b]);
    for (int b = 0; b < m; ++b) add(now[b], moments[b]);
  }
}

// Present overlaps into shared_depth.
template <class Place> void measure(LaneBlock* blocks, int n, const Place& place)
{
  LaneGeometry geometry;
  for (int b = 0; b < n; ++b) {
    place(blocks[b], geometry);
    for (int l = 0; l < lane_width; l += Wide::lanes)
      contact_of(blocks[b], geometry, l).overlap.store(blocks[b].shared_depth + l);
  }
}
} // namespace

void evaluate_pairs(const BodyRecords& bodies, const ContactProperties& pair, double dt,
                    ContactLanes& lanes, BodySums& sums)
{
  LaneBlock* blocks = lanes.blocks().data();
  const int n = static_cast<int>(lanes.blocks().size());
  const auto place = [&](const LaneBlock& block, LaneGeometry& geometry) {
    place_pairs(bodies, block, geometry);
  };
  if (pair.share_among_contacts) {
    measure(blocks, n, place);
    share_contacts(0, lanes.size(), lanes);
  }
  WrenchSum run;
  double* crushing = pair.crushing_pressure > 0 ? sums.crushing() : nullptr;
  with_law(pair, [&](auto shared, const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    run_stages<decltype(shared)::value>(law, dt, blocks, n, place,
                                        [&](const LaneBlock& block, const LaneMoments& moments) {
                                          add_pairs(block, moments, run, sums.data());
                                          if constexpr (Law::crushes)
                                            add_crushing_of_pairs(block, moments, crushing);
                                        });
  });
}

void evaluate_wall(const BodyRecords& bodies, double dt, WallSegment segment, ContactLanes& lanes,
                   BodySums& sums, Wall& wall)
{
  const WallPlane plane(wall);
  LaneBlock* blocks = lanes.blocks().data() + segment.begin / lane_width;
  const int n = (segment.end - segment.begin + lane_width - 1) / lane_width;
  const auto place = [&](const LaneBlock& block, LaneGeometry& geometry) {
    place_at_wall(bodies, plane, block, geometry);
  };
  if (wall.contact.share_among_contacts) {
    measure(blocks, n, place);
    share_contacts(segment.begin, segment.end, lanes);
  }
  LaneVector<Wide> on_stones{0., 0., 0.};
  double* crushing = wall.contact.crushing_pressure > 0 ? sums.crushing() : nullptr;
  with_law(wall.contact, [&](auto shared, const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    run_stages<decltype(shared)::value>(law, dt, blocks, n, place,
                                        [&](const LaneBlock& block, const LaneMoments& moments) {
                                          add_at_wall(block, moments, on_stones, sums.data());
                                          if constexpr (Law::crushes)
                                            add_crushing_at_wall(block, moments, crushing);
                                        });
  });
  Row parts[3];
  store(parts, 0, on_stones);
  for (int c = 0; c < 3; ++c)
    wall.force[c] = -std::accumulate(parts[c], parts[c] + Wide::lanes, 0.);
}
} // namespace interlock::dem
