package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.MovedObject;
import org.pendant.controller.world.MovedScene;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;

/** Belts, and parts that come and go. */
class BeltProgramTest {
  private static final String OBJECTS =
      "'objects': [{'type': 'box', 'name': 'conveyor', 'pose': [0, -0.5, 0.05, 0, 0, 0], 'size':"
          + " [1.2, 0.2, 0.1]}, {'type': 'box', 'name': 'part', 'pose': [-0.4, -0.5, 0.125, 0, 0,"
          + " 0], 'size': [0.05, 0.05, 0.05], 'mass': 0.2}]";

  private static final String BELT =
      "{'type': 'belt', 'object': 'conveyor', 'speed': 0.2, 'encoder': 0, 'ticks': 10000%s}";

  private static byte[] file(String devices) {
    return ("{'devices': [" + devices + "], " + OBJECTS + "}")
        .replace('\'', '"')
        .getBytes(StandardCharsets.UTF_8);
  }

  private static RunningProgram cell(String devices) throws JsonException {
    byte[] text = file(devices);
    return new RunningProgram(
        ControllerOptions.headless()
            .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
            .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text))));
  }

  private static double x(RunningProgram program, int part) {
    return program.state().moved().get(part).poseInBase().x();
  }

  private static long there(RunningProgram program) {
    return program.state().moved().stream().filter(MovedObject::there).count();
  }

  @Test
  void aBeltCarriesAPartAndTurnsItsEncoder() throws Exception {
    RunningProgram program = cell(BELT.formatted(""));
    program.advance(500);
    double from = x(program, 0);
    int count = program.state().encoders().first();
    program.advance(1000);
    assertEquals(0.4, x(program, 0) - from, 0.0005);
    assertEquals(4000, program.state().encoders().first() - count, 2);
  }

  @Test
  void aBeltRunsWhileItsOutputIsOn() throws Exception {
    RunningProgram program = cell(BELT.formatted(", 'run': 'digital_out[3]'"));
    program.run(
        """
        def f():
          sleep(1)
          set_standard_digital_out(3, True)
          sleep(1)
          set_standard_digital_out(3, False)
          sleep(1)
        end
        """);
    assertEquals(-0.4 + 0.2, x(program, 0), 0.005);
    assertEquals(2000, program.state().encoders().first(), 20);
    double before = x(program, 0);
    program.advance(500);
    assertEquals(before, x(program, 0), 1e-6);
  }

  @Test
  void aSourceMakesNoMorePartsThanItHas() throws Exception {
    RunningProgram program =
        cell(
            BELT.formatted("")
                + ", {'type': 'source', 'object': 'part', 'every': 0.5, 'count': 4}");
    program.advance(2000);
    assertEquals(4, there(program));
    assertTrue(
        program
            .reported()
            .contains("source: all 4 parts are in the cell; the next waits for a sink"),
        () -> program.reported().toString());
  }

  @Test
  void aPartWaitsUntilThereIsRoomForIt() throws Exception {
    RunningProgram program = cell("{'type': 'source', 'object': 'part', 'every': 0.1, 'count': 4}");
    program.advance(500);
    assertEquals(1, there(program));
  }

  @Test
  void aSinkTakesPartsAndTheSourceHasThemAgain() throws Exception {
    RunningProgram program =
        cell(
            BELT.formatted("")
                + ", {'type': 'source', 'object': 'part', 'every': 1, 'count': 3}, {'type':"
                + " 'sink', 'min': [-0.1, -0.6, 0], 'max': [0.1, -0.4, 1]}");
    program.advance(5000);
    assertTrue(there(program) >= 1 && there(program) <= 3, "there: " + there(program));
    assertTrue(program.state().moved().stream().allMatch(each -> each.poseInBase().x() < -0.09));
    assertTrue(program.reported().stream().noneMatch(each -> each.contains("waits for a sink")));
  }

  @Test
  void copiesAreShownWhereTheyAre() throws Exception {
    RunningProgram program =
        cell(BELT.formatted("") + ", {'type': 'source', 'object': 'part', 'every': 1}");
    program.advance(600);
    Scene real = SceneReader.read("cell.json", new ByteArrayInputStream(file("")));
    List<String> names =
        MovedScene.of(real, program.state().moved()).objects().stream()
            .map(each -> each.name())
            .toList();
    assertEquals(List.of("conveyor", "part", "part #2"), names);
    List<MovedObject> gone =
        List.of(new MovedObject("part", program.state().moved().getFirst().poseInBase(), false));
    assertEquals(1, MovedScene.of(real, gone).objects().size());
  }

  @Test
  void tenRunsAreEqualToTheBit() throws Exception {
    List<MovedObject> first = run();
    for (int i = 0; i < 9; i++) {
      assertEquals(first, run());
    }
  }

  private static List<MovedObject> run() throws Exception {
    RunningProgram program =
        cell(
            BELT.formatted("")
                + ", {'type': 'source', 'object': 'part', 'every': 0.4, 'count': 5}, {'type':"
                + " 'sink', 'min': [-0.1, -0.6, 0], 'max': [0.1, -0.4, 1]}");
    program.advance(1500);
    return program.state().moved();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{'type': 'belt', 'object': 'part', 'speed': 1} | 41: object is \"part\", must be the name"
            + " of a box that stands still",
        "{'type': 'belt', 'object': 'conveyor', 'speed': 3} | 62: speed is 3 m/s, must be -2 to 2"
            + " m/s",
        "{'type': 'source', 'object': 'conveyor', 'every': 1} | 43: object is \"conveyor\", must"
            + " be the name of an object with a mass",
        "{'type': 'source', 'object': 'part'} | 14: a source has neither every nor when, must have"
            + " one",
        "{'type': 'source', 'object': 'part', 'every': 1, 'count': 100000} | 72: count is 100000,"
            + " must be 1 to 100",
        "{'type': 'source', 'object': 'part', 'every': 1, 'count': 60}, {'type': 'source', 'name':"
            + " 'b', 'object': 'part', 'every': 1, 'count': 60} | 77: sources have 120 parts"
            + " together, must be at most 100"
      })
  void whatCannotBeIsRefusedWithItsPlace(String devices, String message) {
    JsonException refused =
        assertThrows(
            JsonException.class,
            () -> EquipmentReader.read("cell.json", new ByteArrayInputStream(file(devices))));
    assertEquals("cell.json:1:" + message, refused.getMessage());
  }
}
