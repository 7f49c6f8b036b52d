"""A report.html in headless Chromium, opened from disk without a network, drawn without a graphics card.

For regression/apps_report_page.py and performance/report_page.py. Needs Debian's chromium-driver and python3-selenium.
"""

import os
import time

from selenium import webdriver

# swiftshader: Chromium's own renderer without a graphics card, the same on every machine.
ARGUMENTS = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             "--hide-scrollbars", "--host-resolver-rules=MAP * ~NOTFOUND", "--disable-background-networking"]
DESKTOP, PHONE = (1400, 1000, False), (390, 844, True)


class Browser:
    def __init__(self, size=DESKTOP, is_dark=False, more=()):
        options = webdriver.chrome.options.Options()
        options.binary_location = "/usr/bin/chromium"
        for argument in [*ARGUMENTS, f"--window-size={size[0]},{size[1]}", *more]:
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        service = webdriver.chrome.service.Service("/usr/bin/chromedriver")
        self.driver = webdriver.Chrome(options=options, service=service)
        self.driver.set_script_timeout(600)
        self.process = service.process.pid
        width, height, is_phone = size
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height,
                     deviceScaleFactor=2 if is_phone else 1, mobile=is_phone)
        if is_dark:
            self.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])

    def command(self, name, **parameters):
        return self.driver.execute_cdp_cmd(name, parameters)

    def open(self, page, patience=120):
        """Returns when everything of the page is there."""
        self.driver.get("file://" + os.path.abspath(page))
        if not self.waits_for("return window.isComplete === true", patience):
            raise TimeoutError(f"{page}: not complete after {patience} s: {self.complaints()}")

    def waits_for(self, script, patience=60):
        """Whether the script has come out true within so many seconds."""
        end = time.monotonic() + patience
        while not self.run(script):
            if time.monotonic() > end:
                return False
            time.sleep(0.05)
        return True

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def key(self, name):
        """As a reader types it; names of KeyboardEvent.key."""
        self.command("Input.dispatchKeyEvent", type="keyDown", key=name, text=name if len(name) == 1 else "")
        self.command("Input.dispatchKeyEvent", type="keyUp", key=name)

    def click(self, x, y):
        """At a place of the page [px]."""
        for kind in ("mousePressed", "mouseReleased"):
            self.command("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def complaints(self):
        """Errors and warnings of the page since the last call."""
        return [row["message"] for row in self.driver.get_log("browser") if row["level"] in ("SEVERE", "WARNING")]

    def picture(self, path):
        self.driver.save_screenshot(path)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()
