package org.pendant.gui.session;

import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.protocols.ScriptDoors;
import org.pendant.protocols.reach.AllowedHosts;

/**
 * A controller that nobody drives yet.
 *
 * @param options it was made with
 * @param doors by which its programs reach other computers
 */
record SwitchedOn(ControllerOptions options, ScriptDoors doors, Controller controller) {
  /**
   * Switches one on.
   *
   * @throws IllegalArgumentException if the robot or an input is not known
   */
  static SwitchedOn with(ControllerOptions options) {
    ScriptDoors doors = new ScriptDoors(AllowedHosts.ANY);
    return new SwitchedOn(options, doors, new Controller(options.withOutside(doors.doors())));
  }
}
