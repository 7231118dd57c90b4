"""ur_rtde's DashboardClient: a whole power cycle, then load, play, pause and stop."""

# serve: --programs {folder} --power-time 0.5

import gzip
import pathlib
import signal
import sys
import time

from dashboard_client import DashboardClient

HOST = sys.argv[1]
GIVE_UP_S = 60

TURNING = """def turning():
  while True:
    movej([0.2, -1.57, -1.57, -1.57, 1.57, 0])
    movej([0, -1.57, -1.57, -1.57, 1.57, 0])
  end
end
"""

TREE = """<?xml version="1.0" encoding="UTF-8"?>
<URProgram name="turning" installation="cell" createdIn="5.24.1">
  <children><MainProgram><children><Move/></children></MainProgram></children>
</URProgram>
"""

ALONE = """<?xml version="1.0" encoding="UTF-8"?>
<URProgram name="alone" installation="cell" createdIn="5.24.1">
  <children><MainProgram runOnlyOnce="false"><children>
    <Wait type="Sleep"><waitTime>0.5</waitTime></Wait>
  </children></MainProgram></children>
</URProgram>
"""

signal.alarm(GIVE_UP_S)


def check(what, expected, found):
    print(what, repr(found))
    if expected != found:
        raise AssertionError(f"{what}: expected {expected!r}, found {found!r}")


def awaited(what, expected, ask):
    """Asks until the answer is the expected one; the alarm ends what never comes."""
    seen = []
    while not seen or seen[-1] != expected:
        answer = ask()
        if not seen or seen[-1] != answer:
            seen.append(answer)
        time.sleep(0.01)
    print(what, " > ".join(seen))
    return seen


# the box reads programs from the folder that this runs in
pathlib.Path("turning.script").write_text(TURNING)
pathlib.Path("turning.urp").write_bytes(gzip.compress(TREE.encode()))
pathlib.Path("alone.urp").write_bytes(gzip.compress(ALONE.encode()))
pathlib.Path("broken.urp").write_bytes(gzip.compress(TREE.encode())[:40])

client = DashboardClient(HOST)
client.connect()
check("connected", True, client.isConnected())
check("version", "5.24.1.", client.polyscopeVersion()[:7])
check("model", "UR5", client.getRobotModel())
check("serial number is digits", True, client.getSerialNumber().isdigit())
check("remote control", False, client.isInRemoteControl())

# power
check("at first", "Robotmode: POWER_OFF", client.robotmode())
check("safety", "Safetystatus: NORMAL", client.safetystatus())
client.powerOn()
awaited("powering on", "Robotmode: IDLE", client.robotmode)
client.brakeRelease()
steps = awaited("releasing brakes", "Robotmode: RUNNING", client.robotmode)
check("brakes take their time", "Robotmode: IDLE", steps[0])

# programs
check("nothing is loaded", "STOPPED <unnamed>", client.programState())
check("nothing runs", False, client.running())
client.loadURP("turning.urp")
check("loaded", "Loaded program: /programs/turning.urp", client.getLoadedProgram())
check("not playing", "STOPPED turning.urp", client.programState())
client.play()
awaited("playing", "PLAYING turning.urp", client.programState)
check("running", True, client.running())
client.pause()
awaited("pausing", "PAUSED turning.urp", client.programState)
client.play()
awaited("going on", "PLAYING turning.urp", client.programState)
client.stop()
awaited("stopping", "STOPPED turning.urp", client.programState)
for name in ("missing.urp", "broken.urp"):
    try:
        client.loadURP(name)
        raise SystemExit(name + " must not load")
    except RuntimeError as refused:
        print(name, "is refused:", refused)
check("the program stays", "Loaded program: /programs/turning.urp", client.getLoadedProgram())
# a tree of nodes needs no script beside it
client.loadURP("alone.urp")
client.play()
awaited("playing a tree", "PLAYING alone.urp", client.programState)
client.stop()
awaited("stopping a tree", "STOPPED alone.urp", client.programState)

# messages
client.popup("look here")
client.closePopup()
client.closeSafetyPopup()
client.addToLog("the dashboard was here")

# off and on in one
client.powerOff()
awaited("powering off", "Robotmode: POWER_OFF", client.robotmode)
try:
    client.play()
    raise SystemExit("play must be refused while the arm is off")
except RuntimeError as refused:
    print("play is refused:", refused)
client.brakeRelease()
awaited("brake release from off", "Robotmode: RUNNING", client.robotmode)
client.unlockProtectiveStop()
client.restartSafety()
awaited("restarting safety", "Robotmode: POWER_OFF", client.robotmode)
client.quit()
client.disconnect()
