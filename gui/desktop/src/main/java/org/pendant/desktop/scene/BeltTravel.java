package org.pendant.desktop.scene;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.DeviceState;

/**
 * Belt travel: how far belts have gone, to be seen: reckoned from whether they run and how much
 * robot time goes by, back as well as on.
 */
public final class BeltTravel {
  private final Map<String, Double> travelM = new HashMap<>();
  private double lastS = Double.NaN;

  /** Nothing has moved yet. */
  public BeltTravel() {}

  /**
   * Takes another moment.
   *
   * @param timeS robot time
   * @param states of the devices at that moment
   * @return how far each belt has gone, by its name, m
   */
  public Map<String, Double> at(double timeS, List<DeviceSetup> devices, List<DeviceState> states) {
    double wentS = Double.isNaN(lastS) ? 0 : timeS - lastS;
    lastS = timeS;
    for (DeviceSetup each : devices) {
      if (each instanceof DeviceSetup.Belt belt && wentS != 0 && runs(belt, states)) {
        travelM.merge(belt.name(), belt.speedMPerS() * wentS, Double::sum);
      }
    }
    return Map.copyOf(travelM);
  }

  private static boolean runs(DeviceSetup.Belt belt, List<DeviceState> states) {
    return states.stream().anyMatch(each -> each.name().equals(belt.name()) && each.on());
  }
}
