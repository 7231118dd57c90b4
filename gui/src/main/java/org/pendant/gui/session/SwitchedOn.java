package org.pendant.gui.session;

import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.protocols.ScriptDoors;
import org.pendant.protocols.reach.AllowedHosts;
import org.pendant.protocols.toolserial.ToolSerialLine;

/**
 * A controller that nobody drives yet.
 *
 * @param options it was made with
 * @param doors by which its programs reach other computers
 * @param tool the serial line of its tool connector
 */
record SwitchedOn(
    ControllerOptions options, ScriptDoors doors, ToolSerialLine tool, Controller controller) {
  /**
   * Switches one on.
   *
   * @throws IllegalArgumentException if the robot or an input is not known
   */
  static SwitchedOn with(ControllerOptions options) {
    ScriptDoors doors = new ScriptDoors(AllowedHosts.ANY);
    ToolSerialLine tool = new ToolSerialLine();
    return new SwitchedOn(
        options,
        doors,
        tool,
        new Controller(options.withOutside(doors.doors().withToolSerial(tool))));
  }
}
