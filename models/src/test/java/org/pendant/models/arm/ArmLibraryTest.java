package org.pendant.models.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

class ArmLibraryTest {
  @Test
  void everyKnownModelLoads() {
    for (String id : ArmLibrary.ids()) {
      assertEquals(id, ArmLibrary.load(id).id());
    }
  }

  @Test
  void ur5eHasItsPublishedNumbers() {
    ArmDescription arm = ArmLibrary.load("ur5e");
    assertEquals("UR5e", arm.displayName());
    assertEquals(new DhLengths(0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996), arm.dh());
    assertEquals(5, arm.payloadKg());
    assertEquals(0.85, arm.reachM());
    assertEquals(new JointLimits(-2 * Math.PI, 2 * Math.PI, Math.PI, 150), arm.joints().getFirst());
    assertEquals(28, arm.joints().getLast().maxTorqueNm());
    assertEquals(Confidence.VERIFIED, arm.status().kinematics());
  }

  @Test
  void theMovingLinksOfUr5eWeighAsPublished() {
    double sum = ArmLibrary.load("ur5e").links().stream().mapToDouble(LinkMass::massKg).sum();
    assertEquals(17.7, sum, 1e-12);
  }

  @Test
  void inertiasArePossibleForAPhysicalBody() {
    for (String id : ArmLibrary.ids()) {
      for (LinkMass link : ArmLibrary.load(id).links()) {
        String name = id + " " + link.name();
        assertTrue(link.ixx() < link.iyy() + link.izz(), name);
        assertTrue(link.iyy() < link.izz() + link.ixx(), name);
        assertTrue(link.izz() < link.ixx() + link.iyy(), name);
      }
    }
  }

  @Test
  void wrist3OfTheSmallArmsTurnsWithoutEnd() {
    for (String id : ArmLibrary.ids()) {
      assertEquals(
          id.equals("ur3") || id.equals("ur3e"),
          ArmLibrary.load(id).joints().getLast().unlimited(),
          id);
    }
  }

  @Test
  void drivesOfTheRecordedArmsAreMeasuredAndThoseOfTheirSistersDerived() {
    Actuator base = ArmLibrary.load("ur10e").actuators().getFirst();
    assertEquals(6.03, base.rotorInertiaKgM2());
    assertEquals(11.976, base.torqueConstantNmPerA());
    assertEquals(new FrictionCurve(1.429, 0.695, 0.465, 0.819, 0), base.friction());
    Confidence measured = Confidence.MEASURED;
    assertEquals(new Actuator.Status(measured, measured, measured), base.status());
    for (Actuator drive : ArmLibrary.load("ur16e").actuators()) {
      Confidence derived = Confidence.DERIVED;
      assertEquals(new Actuator.Status(derived, derived, derived), drive.status());
    }
  }

  @Test
  void frictionOfEveryDriveIsAboutATwentiethOfItsLargestTorque() {
    for (String id : ArmLibrary.ids()) {
      ArmDescription arm = ArmLibrary.load(id);
      for (int i = 0; i < Joints.COUNT; i++) {
        double share = arm.actuators().get(i).dryNm(0) / arm.joints().get(i).maxTorqueNm();
        assertTrue(share > 0.04 && share < 0.1, id + ", joint " + i + ": " + share);
      }
    }
  }

  @Test
  void biggerJointsHaveHeavierRotors() {
    for (String id : ArmLibrary.ids()) {
      ArmDescription arm = ArmLibrary.load(id);
      for (int i = 1; i < Joints.COUNT; i++) {
        double before = arm.actuators().get(i - 1).rotorInertiaKgM2();
        assertTrue(arm.actuators().get(i).rotorInertiaKgM2() <= before, id + ", joint " + i);
      }
    }
  }

  @Test
  void anUnknownModelIsRefusedWithTheNamesOfTheKnownOnes() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> ArmLibrary.load("ur6"));
    assertEquals(
        "robot: 'ur6' is not known, must be one of " + String.join(", ", ArmLibrary.ids()),
        refused.getMessage());
  }

  @Test
  void modelsAreFoundByIdAndDisplayNameHoweverTheyAreWritten() {
    for (String id : ArmLibrary.ids()) {
      String displayName = ArmLibrary.load(id).displayName();
      assertEquals(Optional.of(id), ArmLibrary.find(id));
      assertEquals(Optional.of(id), ArmLibrary.find(displayName));
      assertEquals(Optional.of(id), ArmLibrary.find(displayName.toUpperCase(Locale.ROOT)));
      assertEquals(Optional.of(id), ArmLibrary.find(displayName.replace(" ", "")));
    }
    assertEquals(Optional.of("ur8long"), ArmLibrary.find(" ur8 long"));
    assertEquals("UR10e", ArmLibrary.load("UR10E").displayName());
  }

  @Test
  void otherNamesAreNotFound() {
    for (String name : new String[] {"", " ", "ur", "ur6", "ur5e.json", "../arm/ur5e"}) {
      assertEquals(Optional.empty(), ArmLibrary.find(name), name);
    }
  }

  @Test
  void aDescriptionWithoutALengthIsRefused() {
    assertEquals(
        "test.json:7:9: key \"a2\" is missing, dh must have it", refusal("\"a2\": -0.425, ", ""));
  }

  @Test
  void numbersThatNoArmHasAreRefusedWithTheName() {
    assertEquals(
        "test.json:7:9: dh: a2 is 0.0 m and a3 is -0.3922 m, neither may be zero",
        refusal("\"a2\": -0.425", "\"a2\": 0"));
    assertEquals(
        "test.json:4:13: series is UR, must be CB3, e-Series or UR-Series",
        refusal("\"e-Series\"", "\"UR\""));
    assertEquals(
        "test.json:5:28: status is sure, must be verified, measured, derived, assumed, estimated or"
            + " missing",
        refusal("\"kinematics\": \"verified\"", "\"kinematics\": \"sure\""));
  }

  @Test
  void numbersBeyondAnyArmAreRefusedWithTheirPlace() {
    assertEquals(
        "test.json:12:26: rotorInertiaKgM2 is 1.0E300, must be -10000 to 10000",
        refusal("\"rotorInertiaKgM2\": 1.92", "\"rotorInertiaKgM2\": 1e300"));
    assertTrue(
        refusal("\"coulombA\": 0.581", "\"coulombA\": -1")
            .startsWith("test.json:13:18: friction: coulombA is -1.0 A, "));
  }

  @Test
  void anArmFileIsReadAndItsIdMustBeAModel() throws IOException, JsonException {
    byte[] file;
    try (InputStream in = ArmLibrary.class.getResourceAsStream("ur5e.json")) {
      file = in.readAllBytes();
    }
    assertEquals(
        ArmLibrary.load("ur5e"), ArmFile.read("mine.json", new ByteArrayInputStream(file)));
    String other = new String(file, StandardCharsets.UTF_8).replace("\"ur5e\"", "\"mine\"");
    byte[] bad = other.getBytes(StandardCharsets.UTF_8);
    JsonException refused =
        assertThrows(
            JsonException.class, () -> ArmFile.read("mine.json", new ByteArrayInputStream(bad)));
    assertEquals(
        "mine.json:2:9: id is \"mine\", must be the model that the arm is one of: "
            + String.join(", ", ArmLibrary.ids()),
        refused.getMessage());
  }

  @Test
  void limitsIncludeTheirEndsThreeDegreesBeyondTheDataSheet() {
    ArmDescription arm = ArmLibrary.load("ur5e");
    double end = 2 * Math.PI + Math.toRadians(3);
    assertTrue(arm.withinLimits(Joints.ZERO.with(3, end)));
    assertTrue(arm.withinLimits(Joints.ZERO.with(3, -end)));
    assertFalse(arm.withinLimits(Joints.ZERO.with(3, end + 1e-6)));
    assertFalse(arm.withinLimits(Joints.ZERO.with(5, Double.NaN)));
  }

  /** What reading the UR5e's file says when {@code piece} of it is replaced. */
  private static String refusal(String piece, String replacement) {
    String good;
    try (InputStream in = ArmLibrary.class.getResourceAsStream("ur5e.json")) {
      good = new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    assertTrue(good.contains(piece), piece);
    byte[] bad = good.replace(piece, replacement).getBytes(StandardCharsets.UTF_8);
    return assertThrows(
            Exception.class,
            () ->
                DescriptionReader.read(
                    new JsonFields(
                        JsonFile.read("test.json", new ByteArrayInputStream(bad)), "an arm")))
        .getMessage();
  }
}
