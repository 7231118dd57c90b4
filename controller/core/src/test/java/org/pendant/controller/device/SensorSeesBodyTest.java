package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.state.RobotBits;
import org.pendant.controller.world.SceneReader;

class SensorSeesBodyTest {
  /** A ball falls past a sensor between 0.38 and 0.42 m; its surface is 4 cm from its middle. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "'light-barrier', 'from': [0.3, 1, 0.4], 'to': [0.7, 1, 0.4], 'radius': 0.02",
        "'proximity', 'at': [0.5, 1, 0.4], 'range': 0.02",
        "'area', 'min': [0.4, 0.9, 0.38], 'max': [0.6, 1.1, 0.42]"
      })
  void aSensorSeesABodyWhileAnyPartOfItIsThere(String sensor) throws Exception {
    byte[] text =
        ("{'devices': [{'signal': 'digital_in[0]', 'type': "
                + sensor
                + "}], 'objects': [{'type': 'sphere', 'name': 'ball', 'centre': [0.5, 1, 1],"
                + " 'radius': 0.04, 'mass': 0.5}]}")
            .replace('\'', '"')
            .getBytes(StandardCharsets.UTF_8);
    RunningProgram program =
        new RunningProgram(
            ControllerOptions.headless()
                .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
                .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text))));
    double first = 0;
    double last = 0;
    for (int frame = 0; frame < 300; frame++) {
      double before = program.state().moved().getFirst().poseInBase().z();
      program.advance(1);
      if ((RobotBits.digitalInputs(program.state().io()) & 1) != 0) {
        first = first == 0 ? before : first;
        last = before;
      }
    }
    assertEquals(0.46, first, 0.01);
    assertEquals(0.34, last, 0.01);
  }
}
