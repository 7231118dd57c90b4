package org.pendant.project.installation.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.safety.ToolDirection;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.project.polyscope.xml.UnreadableFile;

/** The safety settings of PolyScope's installations. */
class SafetySettingsTest {
  private static final double FREE = Double.POSITIVE_INFINITY;

  private static final String LIMITS =
      """
      [SafetySetup]
      verified = true
      withPositionLimits = [true, true, true, true, true, false]

      [SafetyLimits Normal Values]
      maxTcpSpeed = 1.2
      maxForce = 140.0
      maxElbowSpeed = 1.1
      maxElbowForce = 130.0
      maxStoppingDistance = 0.45
      maxStoppingTime = 0.35
      maxPower = 250.0
      maxMomentum = 20.0

      [SafetyLimits Normal Joints]
      maxJointSpeed = [3.0, 2.5, 3.0, 3.0, 3.0, 3.0]
      minJointPosition = [5.0, 6.25, 6.25, 6.25, 6.25, 0.0]
      maxJointPosition = [1.0, 0.05, 0.05, 0.05, 0.05, 0.0]
      minJointRevolutions = [-1, -2, -2, -2, -2, -2147483648]
      maxJointRevolutions = [0, 1, 1, 1, 1, 2147483647]

      [SafetyLimits Reduced Values]
      maxTcpSpeed = 0.3
      maxForce = 110.0
      maxElbowSpeed = 0.4
      maxElbowForce = 105.0
      maxStoppingDistance = 0.25
      maxStoppingTime = 0.2
      maxPower = 90.0
      maxMomentum = 8.0

      [SafetyLimits Reduced Joints]
      maxJointSpeed = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
      minJointPosition = [5.5, 6.25, 6.25, 6.25, 6.25, 0.0]
      maxJointPosition = [0.5, 0.05, 0.05, 0.05, 0.05, 0.0]
      minJointRevolutions = [-1, -2, -2, -2, -2, -2147483648]
      maxJointRevolutions = [0, 1, 1, 1, 1, 2147483647]
      """;

  private static ImportedInstallation read(String settings) throws UnreadableFile {
    return UrInstallations.read(
        ("<Installation>\n<SafetySettings>\n" + settings + "</SafetySettings>\n</Installation>")
            .getBytes(StandardCharsets.UTF_8));
  }

  private static SafetyConfiguration safety(String settings) throws UnreadableFile {
    return read(settings).installation().safety().orElseThrow();
  }

  private static Joints turned(double[] angles, int[] revolutions) {
    double[] joints = new double[Joints.COUNT];
    for (int i = 0; i < joints.length; i++) {
      joints[i] = angles[i] + 2 * Math.PI * revolutions[i];
    }
    return Joints.of(joints);
  }

  @Test
  void setTheLimits() throws UnreadableFile {
    ImportedInstallation read = read(LIMITS);
    assertEquals(List.of(), read.remarks());
    SafetyConfiguration safety = read.installation().safety().orElseThrow();
    int[] below = {-1, -2, -2, -2, -2, 0};
    int[] above = {0, 1, 1, 1, 1, 0};
    assertEquals(
        new SafetyLimits(
            250,
            20,
            0.35,
            0.45,
            1.2,
            140,
            1.1,
            130,
            new Joints(3, 2.5, 3, 3, 3, 3),
            turned(new double[] {5, 6.25, 6.25, 6.25, 6.25, 0}, below).with(5, -FREE),
            turned(new double[] {1, 0.05, 0.05, 0.05, 0.05, 0}, above).with(5, FREE)),
        safety.normal());
    assertEquals(
        new SafetyLimits(
            90,
            8,
            0.2,
            0.25,
            0.3,
            110,
            0.4,
            105,
            new Joints(1, 1, 1, 1, 1, 1),
            turned(new double[] {5.5, 6.25, 6.25, 6.25, 6.25, 0}, below).with(5, -FREE),
            turned(new double[] {0.5, 0.05, 0.05, 0.05, 0.05, 0}, above).with(5, FREE)),
        safety.reduced());
    assertEquals(List.of(), safety.planes());
    assertEquals(Optional.empty(), safety.toolDirection());
  }

  @Test
  void readFilesOfRobotsWithLimitsOfTheirOwnAsTheyAre() throws UnreadableFile {
    String speeds = "[3.3415926535897933, 3.3415926535897933, 3.3415926535897933, ";
    String robot =
        LIMITS
            .replace("[3.0, 2.5, 3.0, ", speeds)
            .replace(
                "3.0, 3.0, 3.0]", "3.3415926535897933, 3.3415926535897933, 3.3415926535897933]");
    Installation cell = read(robot).installation();
    assertEquals(List.of(), InstallationCheck.problems(cell, ArmLibrary.load("ur5e")));
    assertEquals(cell, InstallationText.read(InstallationText.write(cell)).installation());
  }

  private static String plane(int number, String lines) {
    return "[SafetyLimits BoundaryPlane" + number + "]\n" + lines.replace("; ", "\n") + "\n";
  }

  @Test
  void setThePlanesThatAreSwitchedOn() throws UnreadableFile {
    ImportedInstallation read =
        read(
            LIMITS
                + plane(
                    0,
                    "name = Wall; displacement = 0.1; sourceFeatureId = a-b; mode = BOTH;"
                        + " planeNormal = [0.0, -2.0, 0.0]; distanceToOrigin = 1.2;"
                        + " elbowRestricted = true; flangeRestricted = false")
                + plane(
                    1,
                    "name = Off; mode = DISABLED; planeNormal = [0.0, 0.0, 0.0];"
                        + " distanceToOrigin = 0.0; elbowRestricted = true")
                + plane(
                    2,
                    "name = Aisle; mode = TRIGGER; planeNormal = [1.0, 0.0, 0.0];"
                        + " distanceToOrigin = 0.5; elbowRestricted = false")
                + plane(
                    3,
                    "name = Low; mode = NORMAL; planeNormal = [-0.0, 0.0, 1.0];"
                        + " distanceToOrigin = -0.25")
                + plane(
                    7,
                    "name = High; mode = REDUCED; planeNormal = [0, 0, -1];"
                        + " distanceToOrigin = 1"));
    assertEquals(List.of(), read.remarks());
    assertEquals(
        List.of(
            new SafetyPlane("Wall", 0, 0.6, 0, new Axis(0, -1, 0), Applies.BOTH, true),
            new SafetyPlane(
                "Aisle", -0.5, 0, 0, new Axis(1, 0, 0), Applies.TRIGGERS_REDUCED, false),
            new SafetyPlane("Low", 0, 0, 0.25, new Axis(0, 0, 1), Applies.NORMAL, false),
            new SafetyPlane("High", 0, 0, 1, new Axis(0, 0, -1), Applies.REDUCED, false)),
        read.installation().safety().orElseThrow().planes());
  }

  @Test
  void leaveOutPlanesThatCannotBe() throws UnreadableFile {
    ImportedInstallation read =
        read(
            LIMITS
                + plane(
                    0, "name = A; mode = SIDEWAYS; planeNormal = [0, 0, 1]; distanceToOrigin = 0")
                + plane(1, "name = B; mode = BOTH; planeNormal = [0, 0, 0]; distanceToOrigin = 0")
                + plane(2, "name = C; mode = BOTH; planeNormal = [0, 1]; distanceToOrigin = 0")
                + plane(3, "name = D; mode = BOTH; planeNormal = [0, 0, 1]; distanceToOrigin = NaN")
                + plane(4, "name = E; mode = BOTH; planeNormal = [0, 0, 1]; distanceToOrigin = 0"));
    assertEquals(
        List.of("E"),
        read.installation().safety().orElseThrow().planes().stream()
            .map(SafetyPlane::name)
            .toList());
    List<String> remarks = read.remarks();
    assertEquals(8, remarks.size(), remarks::toString);
    assertTrue(
        remarks
            .getFirst()
            .endsWith(
                "mode in [SafetyLimits BoundaryPlane0] is SIDEWAYS, must be DISABLED, NORMAL,"
                    + " REDUCED, BOTH or TRIGGER"),
        remarks.getFirst());
    assertTrue(remarks.get(1).endsWith("is A: this plane is left out"), remarks.get(1));
    assertTrue(remarks.get(2).endsWith("is [0, 0, 0], must be a direction"), remarks.get(2));
    assertTrue(remarks.get(4).endsWith("must be 3 numbers in brackets"), remarks.get(4));
    assertTrue(remarks.get(6).endsWith("is NaN, must be a number"), remarks.get(6));
  }

  @Test
  void giveEachPlaneANameOfItsOwn() throws UnreadableFile {
    String wall = "name = Wall; mode = BOTH; planeNormal = [0, 0, 1]; distanceToOrigin = 1";
    ImportedInstallation read =
        read(LIMITS + plane(0, wall) + plane(1, wall) + plane(2, wall.replace("Wall", "")));
    assertEquals(
        List.of("Wall", "Wall (2)", "Plane 2"),
        read.installation().safety().orElseThrow().planes().stream()
            .map(SafetyPlane::name)
            .toList());
    assertEquals(2, read.remarks().size(), () -> read.remarks().toString());
  }

  @Test
  void setTheDirectionOfTheTool() throws UnreadableFile {
    String direction =
        """
        [WorkpieceConfiguration]
        toolDirectionInclination = 1.5707963267948966
        toolDirectionAzimuth = 1.5707963267948966
        [SafetyLimits ToolOrientation]
        tcpOrientationVector = [0.0, 0.0, -1.0]
        maximumTcpOrientationDeviation = 0.5
        mode = REDUCED
        """;
    ImportedInstallation read = read(LIMITS + direction);
    assertEquals(List.of(), read.remarks());
    ToolDirection tool = read.installation().safety().orElseThrow().toolDirection().orElseThrow();
    assertEquals(new Axis(0, 0, -1), tool.allowedInBase());
    assertEquals(1, tool.toolInFlange().y(), 1e-12);
    assertEquals(0.5, tool.largestAngleRad());
    assertEquals(Applies.REDUCED, tool.applies());
    for (String free :
        List.of(
            direction.replace("REDUCED", "DISABLED"),
            direction.replace("Deviation = 0.5", "Deviation = 3.159045946109736"))) {
      assertEquals(Optional.empty(), safety(LIMITS + free).toolDirection(), free);
      assertEquals(List.of(), read(LIMITS + free).remarks());
    }
    assertEquals(
        2, read(LIMITS + direction.replace("Deviation = 0.5", "Deviation = -1")).remarks().size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "maxTcpSpeed = 1.2|maxTcpSpeed = 100|line 8: maxTcpSpeed in [SafetyLimits Normal Values] is"
            + " 100 m/s, must be 0.01 to 20 m/s; 20 m/s holds",
        "maxPower = 250.0|maxPower = -1e3|line 14: maxPower in [SafetyLimits Normal Values] is"
            + " -1000 W, must be 1 to 10000 W; 1 W holds",
        "maxForce = 110.0|maxForce = 200|line 26: maxForce in [SafetyLimits Reduced Values] is 200"
            + " N, must be at most the normal 140 N, which holds",
        "maxMomentum = 20.0|maxMomentum = NaN|line 15: maxMomentum in [SafetyLimits Normal Values]"
            + " is NaN, must be a number",
        "maxMomentum = 20.0|maxMomentum = 1e999|line 15: maxMomentum in [SafetyLimits Normal"
            + " Values] is 1e999, must be a number",
        "maxMomentum = 20.0|maxMomentum =|line 15: maxMomentum in [SafetyLimits Normal Values] is"
            + " empty, must be a number",
        "maxMomentum = 20.0||the normal limits lack maxMomentum; those of the arm hold",
        "maxMomentum = 8.0||the reduced limits lack maxMomentum; those of normal mode hold",
        "maxMomentum = 20.0|maxMomentum 20.0|line 15: \"maxMomentum 20.0\" in the safety settings"
            + " is left out, must be a key and a value below a heading in brackets",
        "[1.0, 1.0, |[1.0, 0.0, |line 35: maxJointSpeed in [SafetyLimits Reduced Joints] of joint 1"
            + " is 0 rad/s, must be 0.01 to 20 rad/s; 0.01 rad/s holds",
        "[1.0, 1.0, |[|line 35: maxJointSpeed in [SafetyLimits Reduced Joints] is [ 1.0, 1.0, 1.0,"
            + " 1.0], must be 6 numbers in brackets",
        "[1.0, 0.05, |[-2.0, 0.05, |line 19: minJointPosition in [SafetyLimits Normal Joints] lets"
            + " joint 0 be at -1.2831853071795862 to -2.0 rad, must be a range; that of the arm"
            + " holds",
        "[0.5, 0.05, |[1.5, 0.05, |line 36: minJointPosition in [SafetyLimits Reduced Joints] lets"
            + " joint 0 be at -0.7831853071795862 to 1.5 rad, must be a range within the normal"
            + " one; -0.7831853071795862 to 1.0 rad holds",
        "verified = true|verified = false|line 4: verified in [SafetySetup] is false, which is not"
            + " modelled",
        "verified = true|color = red|line 3: not understood in [SafetySetup]: color = red",
        "[SafetySetup]|[Gripper]|line 3: the section [Gripper] is not understood",
        "maxForce = 140.0|maxTcpSpeed = 3|line 9: the second maxTcpSpeed in [SafetyLimits Normal"
            + " Values] is left out",
      })
  void tellWhatIsWrongAndReadTheRest(String right, String wrong, String remark)
      throws UnreadableFile {
    String settings = LIMITS.replaceFirst(Pattern.quote(right), wrong == null ? "" : wrong);
    ImportedInstallation read = read(settings);
    assertTrue(read.remarks().contains(remark), () -> remark + "\n" + read.remarks());
    SafetyConfiguration safety = read.installation().safety().orElseThrow();
    assertEquals(0.45, safety.normal().stoppingDistanceM());
    assertEquals(
        Optional.empty(), InstallationCheck.refusal(read.installation(), ArmLibrary.load("ur5e")));
  }

  @Test
  void nameEachThingThatIsNotModelled() throws UnreadableFile {
    ImportedInstallation read =
        read(
            LIMITS
                + """
                [ThreePositionEnabling]
                useTP3PE = 1
                allowManualHighSpeed = 1
                [SafeHome]
                safeHomeEnabled = 1
                safeHomePosition = [0.0, 4.7, 1.5, 4.7, 1.5, 0.0]
                [Profisafe]
                profisafeEnabled = 1
                profisafeSourceAddress = 4
                [WorkpieceConfiguration]
                toolSpheres = [[0.0, 0.0, 0.0, 0.0, 2], [0.0, 0.0, 0.1, 0.05, 1], [0, 0, 1, 0, 0]]
                toolSphereNames = [null, Grip, DISABLED]
                toolSphereIDs = [a, b, c]
                [SafetyIOConfiguration Inputs]
                emergencyStopInputA = 255
                emergencyStopInputB = 255
                reducedModeInputA = 6
                reducedModeInputB = 7
                safeguardStopResetInputA = 0
                safeguardStopResetInputB = 1
                [SafetyIOConfiguration Outputs]
                robotMovingOutputA = 2
                robotMovingOutputB = 3
                configOut2and3_OSSD = 1
                [Safety Checksum]
                version = 5.12
                crc = 12345
                [MiscConfiguration]
                teach_pendant = 2
                euromap67 = 0
                """);
    List<String> remarks =
        read.remarks().stream().map(each -> each.replaceFirst("line \\d+: ", "")).toList();
    assertEquals(
        List.of(
            "useTP3PE in [ThreePositionEnabling] is 1, which is not modelled",
            "profisafeEnabled in [Profisafe] is 1, which is not modelled",
            "safeHomePosition in [SafeHome] is not modelled",
            "toolSpheres in [WorkpieceConfiguration] has the tool position Grip, [0.0, 0.0, 0.1,"
                + " 0.05, 1], which is not modelled: planes look at the active TCP",
            "reducedModeInputA in [SafetyIOConfiguration Inputs] gives reducedModeInput to"
                + " configurable_in[6] and configurable_in[7], which is not modelled: the safety"
                + " input reduced_mode demands it",
            "safeguardStopResetInputA in [SafetyIOConfiguration Inputs] gives"
                + " safeguardStopResetInput to configurable_in[0] and configurable_in[1], which is"
                + " not modelled",
            "robotMovingOutputA in [SafetyIOConfiguration Outputs] gives robotMovingOutput to"
                + " configurable_out[2] and configurable_out[3], which is not modelled",
            "configOut2and3_OSSD in [SafetyIOConfiguration Outputs] is 1, which is not modelled"),
        remarks);
  }

  @Test
  void thatHoldNothingLeaveTheLimitsOfTheArm() throws UnreadableFile {
    for (String nothing : List.of("", "\n\n", "[SafeHome]\n", "maxTcpSpeed = 1\n", "<a/>")) {
      ImportedInstallation read = read(nothing);
      assertEquals(Optional.empty(), read.installation().safety());
      assertTrue(
          read.remarks()
              .contains(
                  "line 2: the safety settings hold no limits and no planes; the limits of the arm"
                      + " hold"),
          () -> read.remarks().toString());
    }
  }

  @Test
  void thatAreHugeAreReadInBounds() throws UnreadableFile {
    String heading = "[SafetyLimits Normal Values]\n";
    for (String huge :
        List.of(
            heading + "a = 1\n".repeat(100_000),
            heading + "a".repeat(500_000) + " = 1\n",
            "[" + "a".repeat(500_000) + "]\n",
            "[a]\n[b]\n".repeat(50_000),
            heading + "maxTcpSpeed = " + "1".repeat(100_000) + "\n",
            "[SafetyLimits Normal Joints]\nmaxJointSpeed = " + "[".repeat(1900) + "]\n")) {
      ImportedInstallation read = read(huge);
      assertTrue(read.remarks().size() <= SafetyRemarks.MOST + 2);
      assertTrue(
          read.remarks().stream().allMatch(each -> each.length() < 5000),
          () -> read.remarks().getFirst().substring(0, 100));
    }
  }

  @Test
  void readAnythingWithoutFailing() throws UnreadableFile {
    long seed = 20_251_124;
    Random random = new Random(seed);
    String all =
        LIMITS
            + plane(
                0,
                "name = Wall; mode = BOTH; planeNormal = [0.0, -2.0, 0.0]; distanceToOrigin = 1.2;"
                    + " elbowRestricted = true")
            + "[SafetyLimits ToolOrientation]\ntcpOrientationVector = [0.0, 0.0, 1.0]\n"
            + "maximumTcpOrientationDeviation = 0.5\nmode = BOTH\n";
    String[] pieces = {
      "", "-", "1e308", "NaN", "[", "]", ", ", "=", "\n", "0", "Infinity", "-2147483648", "0x1p3"
    };
    for (int round = 0; round < 300; round++) {
      StringBuilder text = new StringBuilder(all);
      for (int i = random.nextInt(4); i >= 0; i--) {
        int at = random.nextInt(text.length());
        int end = Math.min(text.length(), at + random.nextInt(20));
        text.replace(at, end, pieces[random.nextInt(pieces.length)]);
      }
      Installation cell = read(text.toString()).installation();
      assertEquals(
          Optional.empty(),
          InstallationCheck.refusal(cell, ArmLibrary.load("ur5e")),
          () -> seed + ": " + text);
      assertEquals(
          cell,
          InstallationText.read(InstallationText.write(cell)).installation(),
          () -> seed + ": " + text);
    }
  }
}
