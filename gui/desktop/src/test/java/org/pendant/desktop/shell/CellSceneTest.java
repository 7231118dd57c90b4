package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.desktop.scene.DeviceSight;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneFile;

/** Which devices are in the picture. */
final class CellSceneTest {
  private static final String SENSOR =
      """
      {"devices": [
        {"type": "proximity", "name": "eye", "signal": "digital_in[0]", "at": [0.4, 0, 0], "range": 0.02}
      ]}
      """;

  private static List<String> seen(DeviceSight sight) {
    return sight.sensors().stream().map(DeviceSight.Sensor::name).toList();
  }

  @Test
  void theDevicesOfADraftAreShownAlsoWhereItHasNoneOrOtherControllers() throws Exception {
    CellEquipment equipment =
        SceneFile.of("eye.scene.json", SENSOR).plan().equipment().devices().getFirst();
    try (RobotSession session =
        RobotSession.start(ControllerOptions.headless().withEquipment(equipment))) {
      CellScene scene = new CellScene(session, () -> false);
      List<DeviceSetup> eye = equipment.devices();
      assertEquals(List.of("eye"), seen(devices(scene, session, Optional.empty())));
      assertEquals(List.of(), seen(devices(scene, session, Optional.of(List.of()))));
      assertEquals(List.of(), seen(devices(scene, session, Optional.of(List.of(List.of())))));
      assertEquals(
          List.of(),
          seen(devices(scene, session, Optional.of(List.of(List.of(), eye, List.of())))));
    }
  }

  private static DeviceSight devices(
      CellScene scene, RobotSession session, Optional<List<List<DeviceSetup>>> draft) {
    return scene.devices(session.state(), false, draft, Optional.empty());
  }
}
