package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;

/** Cameras that tell programs where parts are. */
class CameraProgramTest {
  /** A cube and a ball lie on a floor in view, another cube out of it. */
  private static RunningProgram with(String camera) throws Exception {
    byte[] text =
        ("{'devices': [{'type': 'camera', 'min': [0.3, -0.5, 0], 'max': [0.7, 0.5, 0.3]"
                + camera
                + "}], 'objects': ["
                + "{'type': 'plane', 'name': 'floor', 'point': [0, 0, 0], 'normal': [0, 0, 1]},"
                + "{'type': 'box', 'name': 'cube', 'pose': [0.5, 0.2, 0.02, 0, 0, 0.5],"
                + " 'size': [0.04, 0.04, 0.04], 'mass': 0.1},"
                + "{'type': 'sphere', 'name': 'ball', 'centre': [0.4, -0.2, 0.03],"
                + " 'radius': 0.03, 'mass': 0.1},"
                + "{'type': 'box', 'name': 'far', 'pose': [0.9, 0.2, 0.02, 0, 0, 0],"
                + " 'size': [0.04, 0.04, 0.04], 'mass': 0.1}]}")
            .replace('\'', '"')
            .getBytes(StandardCharsets.UTF_8);
    return new RunningProgram(
        ControllerOptions.headless()
            .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
            .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text))));
  }

  private static String asking(String... requests) {
    StringBuilder program = new StringBuilder("def f():\n  socket_open(\"127.0.0.1\", 50100)\n");
    for (String each : requests) {
      program.append("  socket_send_line(\"" + each + "\")\n  a = socket_read_ascii_float(7)\n");
      program.append("  i = 0\n  while i < 8:\n    textmsg(a[i])\n    i = i + 1\n  end\n");
    }
    return program + "end\n";
  }

  private static void assertNumbers(RunningProgram program, double... expected) {
    List<Double> numbers = program.numbers();
    assertEquals(expected.length, numbers.size(), program.reported().toString());
    for (int i = 0; i < expected.length; i++) {
      assertEquals(expected[i], numbers.get(i), 1e-3, "number " + i);
    }
  }

  @Test
  void whatIsBehindAnotherPartIsNotSeenWithOcclusion() throws Exception {
    String above = ", 'at': [%s, 1, 3.141592653589793, 0, 0], 'objects': ['ball', 'cube']";
    String from = asking("GET");
    RunningProgram beside = with(above.formatted("0.5, 0.2") + ", 'occlusion': true");
    beside.run(from);
    assertEquals(2, beside.numbers().get(1), "from above the cube nothing is in the way");
    String low = ", 'at': [1.3, 0.2, 0.03, 0, 0, 0], 'objects': ['cube']";
    RunningProgram through = with(low);
    through.run(from);
    assertEquals(1, through.numbers().get(1), "without it the far cube hides nothing");
    RunningProgram behind = with(low + ", 'occlusion': true");
    behind.run(from);
    assertEquals(0, behind.numbers().get(1), "the far cube is between");
  }

  @Test
  void occlusionNeedsToKnowWhereTheCameraIs() {
    JsonException refusal = assertThrows(JsonException.class, () -> with(", 'occlusion': true"));
    assertTrue(
        refusal.getMessage().endsWith("at must be there: from where the camera looks"),
        refusal.getMessage());
  }

  @Test
  void whatStandsStillAndTheArmHideParts() throws Exception {
    RunningProgram below =
        with(", 'at': [0.5, 0.2, -0.5, 0, 0, 0], 'objects': ['cube'], 'occlusion': true");
    below.run(asking("GET"));
    assertEquals(0, below.numbers().get(1), "the floor is between");
    String above = ", 'at': [0.5, 0.2, 1.5, 0, 0, 0], 'objects': ['cube'], 'occlusion': true";
    RunningProgram arm = with(above);
    arm.run(
        "def f():\n  set_tcp(p[0, 0, 0.1, 0, 0, 0])\n"
            + "  movej(get_inverse_kin(p[0.5, 0.2, 0.3, 3.14159265, 0, 0]))\n"
            + asking("GET").substring("def f():\n".length()));
    assertEquals(0, arm.numbers().get(1), "the arm is between");
  }

  @Test
  void aSocketAnswersHowManyPartsThereAreAndWhereOneIs() throws Exception {
    RunningProgram program = with("");
    program.run(asking("GET", "GET 1", "GET ball", "GET cube 1"));
    assertNumbers(
        program, 7, 2, 0.5, 0.2, 0.02, 0, 0, 0.5, 7, 2, 0.4, -0.2, 0.03, 0, 0, 0, 7, 1, 0.4, -0.2,
        0.03, 0, 0, 0, 7, 1, 0, 0, 0, 0, 0, 0);
    assertFalse(program.waitsForOutside());
    assertTrue(program.repeats());
    assertTrue(program.state().devices().getFirst().on());
  }

  @Test
  void proceduresTellWhatIsInTheLastPicture() throws Exception {
    RunningProgram program = with(", 'objects': ['cube', 'far']");
    program.run(
        """
        def f():
          camera = rpc_factory("xmlrpc", "http://localhost:50101")
          textmsg(camera.look())
          textmsg(camera.get_name(0))
          at = camera.get_pose(0)
          textmsg(norm(at[5] - 0.5) < 0.001)
          textmsg(camera.look("ball"))
        end
        """);
    assertEquals(List.of("1", "cube", "True", "0"), program.said());
  }

  @Test
  void aPartThatIsNotInThePictureEndsTheProgram() throws Exception {
    RunningProgram program = with("");
    program.start(
        """
        def f():
          camera = rpc_factory("xmlrpc", "http://localhost:50101")
          camera.look()
          camera.get_pose(2)
        end
        """);
    program.finish();
    assertTrue(
        program.reported().toString().contains("number is 2, must be 0 to 1: get_pose"),
        program.reported().toString());
  }

  @Test
  void aCameraWithAPlaceTellsPosesInItsOwnFrame() throws Exception {
    RunningProgram program = with(", 'at': [0.5, 0, 1, 3.141592653589793, 0, 0], 'port': 2000");
    program.run(asking("GET").replace("50100", "2000"));
    List<Double> numbers = program.numbers();
    assertEquals(0, numbers.get(2), 1e-3);
    assertEquals(-0.2, numbers.get(3), 1e-3);
    assertEquals(0.98, numbers.get(4), 1e-3);
  }

  @Test
  void noiseComesFromTheSeed() throws Exception {
    String[] requests = new String[200];
    Arrays.fill(requests, "GET cube");
    RunningProgram first = with(", 'noise': 0.001, 'turn_noise': 0.01, 'seed': 3");
    first.run(asking(requests));
    RunningProgram again = with(", 'noise': 0.001, 'turn_noise': 0.01, 'seed': 3");
    again.run(asking(requests));
    RunningProgram other = with(", 'noise': 0.001, 'turn_noise': 0.01, 'seed': 4");
    other.run(asking(requests));
    assertEquals(first.numbers(), again.numbers());
    assertNotEquals(first.numbers(), other.numbers());
    assertEquals(0.001, deviation(first.numbers(), 2, 0.5), 0.0002);
    assertEquals(0.01, deviation(first.numbers(), 7, 0.5), 0.002);
  }

  private static double deviation(List<Double> numbers, int index, double mean) {
    double sum = 0;
    int count = 0;
    for (int i = index; i < numbers.size(); i += 8) {
      sum += (numbers.get(i) - mean) * (numbers.get(i) - mean);
      count++;
    }
    return Math.sqrt(sum / count);
  }

  @Test
  void whatIsNoRequestIsSaid() throws Exception {
    RunningProgram program = with("");
    program.run(
        """
        def f():
          socket_open("127.0.0.1", 50100)
          socket_send_line("LOOK")
          textmsg(socket_read_line())
        end
        """);
    assertEquals(List.of("?"), program.said());
    assertTrue(
        program.reported().toString().contains("camera: \"LOOK\": must be GET"),
        program.reported().toString());
  }
}
