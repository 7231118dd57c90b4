package org.pendant.protocols.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.Joints;

class RobotStateCodecTest {
  private static final List<Integer> PERIODIC = List.of(0, 1, 4, 9, 3, 2, 7, 8, 10, 11, 12);
  private static final List<Integer> FULL = List.of(0, 1, 4, 5, 9, 3, 2, 6, 7, 8, 10, 11, 12);

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final RobotStateCodec codec = new RobotStateCodec(controller.state().arm().description());

  private record Part(int type, ByteBuffer bytes) {
    int size() {
      return bytes.remaining();
    }

    String hex() {
      return HexFormat.of()
          .formatHex(bytes.array(), bytes.arrayOffset(), bytes.arrayOffset() + size());
    }
  }

  private void carryOut(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    controller.advance();
    assertEquals(new Reply.Done(), reply.join());
  }

  private static List<Part> parts(byte[] state) {
    ByteBuffer all = ByteBuffer.wrap(state);
    assertEquals(state.length, all.getInt());
    assertEquals(16, all.get());
    List<Part> parts = new ArrayList<>();
    while (all.hasRemaining()) {
      int size = all.getInt(all.position());
      Part part = new Part(all.get(all.position() + 4), all.slice(all.position(), size));
      parts.add(part);
      all.position(all.position() + size);
    }
    return parts;
  }

  private Part part(int type) {
    return parts(codec.full(controller.state())).stream()
        .filter(each -> each.type() == type)
        .findFirst()
        .orElseThrow();
  }

  private static List<Integer> types(byte[] state) {
    return parts(state).stream().map(Part::type).toList();
  }

  @Test
  void theFullStateHasAllParts() {
    byte[] state = codec.full(controller.state());
    assertEquals(1386, state.length);
    assertEquals(FULL, types(state));
    assertEquals(
        List.of(47, 251, 101, 225, 53, 75, 37, 445, 61, 9, 43, 26, 8),
        parts(state).stream().map(Part::size).toList());
  }

  @Test
  void thePeriodicStateLeavesOutWhatNeverChanges() {
    byte[] state = codec.periodic(controller.state());
    assertEquals(716, state.length);
    assertEquals(PERIODIC, types(state));
  }

  @Test
  void modesAndSpeed() {
    carryOut(new BoxCommand.SetSpeedFraction(0.97));
    for (int i = 0; i < 49; i++) {
      controller.advance();
    }
    assertEquals(
        RobotMessageCodecTest.hex(
            "0000002F 00 00000000000186A0 01 01 01 00 00 00 00 07 00 3FEF0A3D70A3D70A"
                // no program runs whose speed would be scaled
                + "0000000000000000 3FF0000000000000 00"),
        part(0).hex());
  }

  @Test
  void joints() {
    ByteBuffer joints = part(1).bytes();
    for (int i = 0; i < 6; i++) {
      int at = 5 + 41 * i;
      double q = controller.state().arm().actualPositionRad().get(i);
      assertEquals(q, joints.getDouble(at));
      assertEquals(q, joints.getDouble(at + 8), 1e-6);
      assertEquals(0, joints.getDouble(at + 16), 1e-6);
      assertTrue(joints.getFloat(at + 28) > 40, "voltage");
      assertTrue(joints.getFloat(at + 32) > 10, "temperature");
      assertEquals(0, joints.getFloat(at + 36));
      assertEquals((byte) 253, joints.get(at + 40));
    }
  }

  @Test
  void signalsOfTheMasterboard() {
    carryOut(new IoCommand.SetInput("digital_in[0]", true));
    carryOut(new IoCommand.SetInput("configurable_in[1]", true));
    carryOut(new IoCommand.SetInput("tool_in[0]", true));
    ByteBuffer board = part(3).bytes();
    assertEquals(1 | 1 << 9 | 1 << 16, board.getInt(5));
    assertEquals(0, board.getInt(9));
    assertEquals(1, board.get(65), "safety mode");
    assertEquals(0, board.get(67), "no EUROMAP 67");
  }

  @Test
  void toolFlange() {
    ByteBuffer tool = part(2).bytes();
    assertEquals(0, tool.get(27), "voltage");
    assertEquals((byte) 253, tool.get(36), "mode");
  }

  @Test
  void poseOfTheTool() {
    ByteBuffer pose = part(4).bytes();
    assertEquals(controller.state().arm().actualTcpInBase().x(), pose.getDouble(5), 1e-12);
    assertEquals(0, pose.getDouble(53));
  }

  @Test
  void configurationOfAUr5e() {
    ByteBuffer configuration = part(6).bytes();
    assertEquals(-6.3355451848, configuration.getDouble(5), 1e-9);
    assertEquals(6.3355451848, configuration.getDouble(13), 1e-9);
    assertEquals(3.341592653589793, configuration.getDouble(101), 1e-12);
    assertEquals(40, configuration.getDouble(109));
    assertEquals(1.0471975511965976, configuration.getDouble(197), 1e-15);
    assertEquals(1.3962634015954636, configuration.getDouble(205), 1e-15);
    assertEquals(-0.425, configuration.getDouble(245));
    assertEquals(0.1625, configuration.getDouble(285));
    assertEquals(Math.PI / 2, configuration.getDouble(333));
    assertEquals(6, configuration.getInt(429));
    assertEquals(4, configuration.getInt(433));
    assertEquals(1, configuration.getInt(437));
    assertEquals(3, configuration.getInt(441));
  }

  @Test
  void kinematicsOfAnArmWithoutCalibration() {
    ByteBuffer kinematics = part(5).bytes();
    assertEquals(-1, kinematics.getInt(5));
    assertEquals(0, kinematics.getDouble(29), "theta");
    assertEquals(-0.425, kinematics.getDouble(85), "a");
    assertEquals(0.1625, kinematics.getDouble(125), "d");
    assertEquals(0, kinematics.getInt(221), "calibration status");
  }

  @Test
  void kinematicsOfACalibratedArm() {
    DhDeltas deltas =
        new DhDeltas(
            new Joints(-2.41e-07, 1.5, -1.5, 0.0837, 0, 3.9e-08),
            new Joints(2.122e-05, 0.5, 0, 0, 0, 0),
            new Joints(0, 439.125, -446, 7, 0, 0),
            new Joints(0, 0, 0, 0, 0.0625, 0));
    Calibration calibration =
        new Calibration(
            deltas, List.of(0xADBB5, -2, 3, 4, 5, 0x7FFFFFFF), Calibration.Status.LINEARISED);
    Controller calibrated =
        new Controller(ControllerOptions.headless().withCalibration(calibration));
    byte[] state =
        new RobotStateCodec(calibrated.state().arm().description()).full(calibrated.state());
    Part part = parts(state).stream().filter(each -> each.type() == 5).findFirst().orElseThrow();
    assertTrue(
        part.hex()
            .startsWith(
                RobotMessageCodecTest.hex(
                    "000000E1 05 000ADBB5 FFFFFFFE 00000003 00000004 00000005 7FFFFFFF"
                        + " BE902C59358C9002 3FF8000000000000 BFF8000000000000")),
        part::hex);
    assertEquals(3.9e-08, part.bytes().getDouble(69), "theta of the last joint");
    assertEquals(2.122e-05, part.bytes().getDouble(77), "a of the first joint");
    assertEquals(-0.425 + 0.5, part.bytes().getDouble(85), "a of the second joint");
    assertEquals(439.125, part.bytes().getDouble(133), "d of the second joint");
    assertEquals(0.1333 + 7, part.bytes().getDouble(149), "d of the fourth joint");
    assertEquals(Math.PI / 2, part.bytes().getDouble(173), "alpha of the first joint");
    assertEquals(-Math.PI / 2 + 0.0625, part.bytes().getDouble(205), "alpha of the fifth joint");
    assertEquals(2, part.bytes().getInt(221), "calibration status");
  }

  @Test
  void toolCommunicationToolModeAndAdditionalInformation() {
    assertEquals(
        RobotMessageCodecTest.hex("0000001A 0B 00 0001C200 00000000 00000001 3FC00000 40600000"),
        part(11).hex());
    assertEquals(RobotMessageCodecTest.hex("00000008 0C 00 01 01"), part(12).hex());
    assertEquals(RobotMessageCodecTest.hex("00000009 08 00 01 00 01"), part(8).hex());
  }

  @Test
  void toolCommunicationAsAProgramSetItUp() {
    String text = "set_tool_communication(True, 9600, 2, 2, 40, 0)\n";
    carryOut(new ProgramCommand.StartProgram(TestController.program(controller, text)));
    assertEquals(
        RobotMessageCodecTest.hex("0000001A 0B 01 00002580 00000002 00000002 42200000 00000000"),
        part(11).hex());
  }

  @Test
  void everyArmHasAConfiguration() {
    for (String id : ArmLibrary.ids()) {
      int type = ConfigurationParts.robotType(id);
      assertTrue(type >= 1 && type <= 9, id);
      ByteBuffer bytes = ByteBuffer.wrap(ConfigurationParts.configuration(ArmLibrary.load(id)));
      for (int i = 0; i < 12; i++) {
        assertTrue(Double.isFinite(bytes.getDouble(5 + 8 * i)), id);
      }
    }
  }
}
