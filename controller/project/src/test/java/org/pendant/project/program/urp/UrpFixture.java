package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Step;

/** Texts of PolyScope's programs, and what is read from them. */
final class UrpFixture {
  static final Joints JOINTS = new Joints(0.1, -1.5, -1.6, -1.4, 1.5, 0.2);

  /** As robots write a place: joints, TCP and the arm, but no pose. */
  static final String POSITION =
      """
      <position>
        <JointAngles angles="0.1, -1.5, -1.6, -1.4, 1.5, 0.2"/>
        <TCPOffset pose="0.0, 0.0, 0.12, 0.0, 0.0, 0.0"/>
        <Kinematics status="NOT_INITIALIZED" validChecksum="false">
          <deltaTheta value="0.0, 0.0, 0.0, 0.0, 0.0, 0.0"/>
          <a value="0.0, -0.425, -0.3922, 0.0, 0.0, 0.0"/>
          <d value="0.1625, 0.0, 0.0, 0.1333, 0.0997, 0.0996"/>
          <alpha value="1.570796327, 0.0, 0.0, 1.570796327, -1.570796327, 0.0"/>
          <jointChecksum value="-1, -1, -1, -1, -1, -1"/>
        </Kinematics>
      </position>
      """;

  static String program(String sections) {
    return "<URProgram name=\"pick\" installation=\"cell\" createdIn=\"5.24.1\">\n<children>\n"
        + sections
        + "\n</children>\n</URProgram>\n";
  }

  static String main(String nodes) {
    return program(
        "<MainProgram runOnlyOnce=\"true\"><children>\n" + nodes + "\n</children></MainProgram>");
  }

  static ImportedProgram read(String xml) throws UnreadableFile {
    return UrpPrograms.read("pick.urp", xml.getBytes(StandardCharsets.UTF_8));
  }

  /** The nodes of a main program. */
  static List<ProgramNode> nodes(String xml) throws UnreadableFile {
    return read(main(xml)).tree().sections().getFirst().children();
  }

  static Step step(String xml) throws UnreadableFile {
    return nodes(xml).getFirst().step();
  }

  static String expression(String parts) throws UnreadableFile {
    Step step = step("<Script type=\"Line\"><expression>" + parts + "</expression></Script>");
    return ((ActionStep.ScriptLine) step).code();
  }

  static String chars(String text) {
    StringBuilder parts = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      String each = text.substring(i, i + 1).replace("<", "&lt;").replace("\"", "&quot;");
      parts.append("<ExpressionChar character=\"").append(each).append("\"/>");
    }
    return parts.toString();
  }

  static String refusal(byte[] bytes) {
    return assertThrows(UnreadableFile.class, () -> UrpPrograms.read("pick.urp", bytes))
        .report("pick.urp");
  }

  static String refusal(String xml) {
    return refusal(xml.getBytes(StandardCharsets.UTF_8));
  }

  static void assertPose(Pose expected, Pose actual) {
    for (int i = 0; i < Pose.SIZE; i++) {
      assertEquals(expected.get(i), actual.get(i), 1e-9, () -> expected + " and " + actual);
    }
  }

  private UrpFixture() {}
}
