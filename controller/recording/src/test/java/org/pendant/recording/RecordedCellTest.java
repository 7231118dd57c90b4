package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.SceneReader;

/** Bodies and devices in recordings. */
final class RecordedCellTest {
  private static final byte[] CELL =
      """
      {"devices": [{"type": "belt", "object": "conveyor", "speed": 0.2},
        {"type": "source", "object": "part", "every": 0.5, "count": 3},
        {"type": "rg"}],
       "objects": [
        {"type": "box", "name": "conveyor", "pose": [0, -0.5, 0.05, 0, 0, 0], "size": [2, 0.2, 0.1]},
        {"type": "box", "name": "part", "pose": [-0.8, -0.5, 0.125, 0, 0, 0],
          "size": [0.05, 0.05, 0.05], "mass": 0.2}]}
      """
          .getBytes(StandardCharsets.UTF_8);

  @TempDir Path folder;

  private static List<ControllerState> run() throws Exception {
    Controller controller =
        new Controller(
            ControllerOptions.headless()
                .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(CELL)))
                .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(CELL))));
    List<ControllerState> states = new ArrayList<>(List.of(controller.state()));
    for (int i = 0; i < 600; i++) {
      controller.advance();
      states.add(controller.state());
    }
    return states;
  }

  private static byte[] bytes(List<ControllerState> states) throws Exception {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (RecordingWriter writer = new RecordingWriter(out, states.getFirst())) {
      for (ControllerState each : states.subList(1, states.size())) {
        writer.write(each);
      }
    }
    return out.toByteArray();
  }

  @Test
  void aRecordingShowsBodiesAndDevicesWhereTheyWere() throws Exception {
    List<ControllerState> states = run();
    Path file = Files.write(folder.resolve("cell.rec"), bytes(states));
    Recording recording = RecordingFile.open(file).recording();
    for (int frame : new int[] {0, 100, 345, 600}) {
      ControllerState wanted = states.get(frame);
      ControllerState found = recording.at(wanted.timeS());
      assertEquals(wanted.moved(), found.moved(), "frame " + frame);
      assertEquals(wanted.devices(), found.devices(), "frame " + frame);
    }
    assertEquals(states.get(345).moved(), recording.at(states.get(348).timeS()).moved());
    assertTrue(states.get(600).moved().size() == 3 && states.get(100).moved().size() == 1);
  }

  @Test
  void recordingsOfEqualRunsAreEqualToTheByte() throws Exception {
    assertEquals(
        new String(bytes(run()), StandardCharsets.ISO_8859_1),
        new String(bytes(run()), StandardCharsets.ISO_8859_1));
  }
}
