package org.pendant.models.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Confidence;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

@Tag("slow")
class ArmShapesTest {
  /** A slit that a drawing may show between two bodies, m. */
  private static final double SLIT_M = 0.01;

  static Stream<String> ids() {
    return ArmLibrary.ids().stream();
  }

  @ParameterizedTest
  @MethodSource("ids")
  void everyArmHasAShape(String id) {
    assertEquals(id, ArmShapes.load(id).id());
  }

  @ParameterizedTest
  @MethodSource("ids")
  void limbsAreAsLongAsTheKinematicsSay(String id) {
    ArmShape shape = ArmShapes.load(id);
    DhLengths dh = ArmLibrary.load(id).dh();
    assertEquals(-dh.a2(), shape.upperArm().lengthM(), 1e-9);
    assertEquals(-dh.a3(), shape.forearm().lengthM(), 1e-9);
  }

  @ParameterizedTest
  @MethodSource("ids")
  void bodiesMeetTheirNeighboursAtTheJoints(String id) {
    ArmShape shape = ArmShapes.load(id);
    DhLengths dh = ArmLibrary.load(id).dh();
    JointHousing shoulder = shape.shoulder();
    JointHousing wrist1 = shape.wrist1();
    JointHousing wrist2 = shape.wrist2();

    // Along each joint's axis, from the near body to the far one. Where the next axis points along
    // negative y, the near body ends at its smallest y.
    assertMeet("1", shape.base().heightM(), dh.d1() + shoulder.alongZ().fromM());
    assertMeet("2", -shoulder.alongY().fromM(), shape.upperArm().near().fromM());
    assertMeet("3", shape.forearm().near().toM(), shape.upperArm().far().fromM());
    assertMeet("4", shape.forearm().far().toM(), dh.d4() + wrist1.alongZ().fromM());
    assertMeet("5", -wrist1.alongY().fromM(), dh.d5() + wrist2.alongZ().fromM());
    assertMeet("6", wrist2.alongY().toM(), dh.d6() + shape.wrist3().alongZ().fromM());
    assertMeet("flange", shape.wrist3().alongZ().toM(), 0);
  }

  /** Overlapping is fine for a drawing, but by less than the bodies are thick. */
  private static void assertMeet(String joint, double endM, double beginM) {
    double slitM = beginM - endM;
    assertTrue(slitM < SLIT_M && slitM > -3 * SLIT_M, () -> "joint " + joint + ": " + slitM + " m");
  }

  @ParameterizedTest
  @MethodSource("ids")
  void tubesRunFromHousingToHousing(String id) {
    ArmShape shape = ArmShapes.load(id);
    for (Limb limb : List.of(shape.upperArm(), shape.forearm())) {
      double centreM = limb.tube().centreZM();
      for (Cylinder housing : List.of(limb.near(), limb.far())) {
        assertTrue(centreM > housing.fromM() && centreM < housing.toM(), limb::toString);
        assertTrue(limb.tube().middleRadiusM() < 1.15 * housing.radiusM(), limb::toString);
      }
      assertTrue(limb.near().radiusM() + limb.far().radiusM() < limb.lengthM(), limb::toString);
    }
  }

  @Test
  void shapesTellWhereTheyComeFrom() {
    assertEquals(Confidence.MEASURED, ArmShapes.load("ur5e").status());
    assertEquals(Confidence.ASSUMED, ArmShapes.load("ur7e").status());
    assertEquals(Confidence.ASSUMED, ArmShapes.load("ur12e").status());
    for (String id : List.of("ur8long", "ur15", "ur18")) {
      assertEquals(Confidence.ESTIMATED, ArmShapes.load(id).status(), id);
    }
  }

  @Test
  void sistersLookAlike() {
    assertEquals(ArmShapes.load("ur5e").forearm(), ArmShapes.load("ur7e").forearm());
    assertEquals(ArmShapes.load("ur10e").forearm(), ArmShapes.load("ur12e").forearm());
    assertEquals(ArmShapes.load("ur15").wrist1(), ArmShapes.load("ur8long").wrist1());
  }

  @Test
  void unknownArmsAreRefusedAsInTheLibrary() {
    String message =
        assertThrows(IllegalArgumentException.class, () -> ArmShapes.load("ur6")).getMessage();
    assertEquals(
        "robot: 'ur6' is not known, must be one of " + String.join(", ", ArmLibrary.ids()),
        message);
  }

  @Test
  void impossibleBodiesAreRefused() {
    assertRefused("cylinder: radius is 0.0 m, must be above 0", () -> new Cylinder(0, 0, 1));
    assertRefused(
        "cylinder: goes from 1.0 m to 0.0 m, the end must be above the begin",
        () -> new Cylinder(0.1, 1, 0));
    assertRefused(
        "base: height is 0.1 m, radii are NaN m and 0.1 m, all must be above 0",
        () -> new Base(0.1, Double.NaN, 0.1));
    assertRefused(
        "tube: radii are 0.1, -0.1 and 0.1 m, all must be above 0",
        () -> new Tube(0, 0.1, -0.1, 0.1));
    Cylinder housing = new Cylinder(0.1, 0, 1);
    Tube tube = new Tube(0.5, 0.1, 0.1, 0.1);
    assertRefused(
        "limb: length is -0.4 m, must be above 0", () -> new Limb(-0.4, housing, housing, tube));
  }

  private static void assertRefused(String message, Executable action) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, action).getMessage());
  }

  @Test
  void aFileWithAnImpossibleBodyIsRefused() throws Exception {
    String json =
        """
        {"id": "x", "status": "measured",
         "base": {"heightM": 0, "footRadiusM": 0.1, "topRadiusM": 0.1}}
        """;
    InputStream in = new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8));
    JsonFields root = new JsonFields(JsonFile.read("x.json", in), "a shape");
    assertRefused(
        "base: height is 0.0 m, radii are 0.1 m and 0.1 m, all must be above 0",
        () -> ArmShapes.read(root));
  }
}
