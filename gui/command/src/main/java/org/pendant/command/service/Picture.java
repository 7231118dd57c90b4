package org.pendant.command.service;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.controller.world.Scene;

/**
 * Picture of an arm in its world.
 *
 * @param robotId which arm it is
 * @param arm where it stands
 * @param world objects around it
 * @param devices of the cell
 * @param deviceStates what they are at
 * @param limits of which safety planes and the tool direction are drawn; empty for none to draw
 * @param safety what the safety functions do
 * @param view from where it is seen
 * @param dark whether the colours are those of the dark theme
 * @param widthPx width, pixels
 * @param heightPx height, pixels
 */
public record Picture(
    String robotId,
    ArmState arm,
    Scene world,
    List<DeviceSetup> devices,
    List<DeviceState> deviceStates,
    Optional<SafetyConfiguration> limits,
    SafetyStatus safety,
    StandardView view,
    boolean dark,
    int widthPx,
    int heightPx) {
  /** Copies the lists. */
  public Picture {
    devices = List.copyOf(devices);
    deviceStates = List.copyOf(deviceStates);
  }
}
