package org.pendant.models.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

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
  void anUnknownModelIsRefusedWithTheNamesOfTheKnownOnes() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> ArmLibrary.load("ur6"));
    assertEquals(
        "robot: 'ur6' is not known, must be one of " + String.join(", ", ArmLibrary.ids()),
        refused.getMessage());
  }

  @Test
  void aDescriptionWithoutALengthIsRefused() {
    IllegalStateException refused =
        assertThrows(
            IllegalStateException.class,
            () -> read("{\"dh\": {\"d1\": 1}, \"status\": {}, \"joints\": [], \"links\": []}"));
    assertTrue(refused.getMessage().startsWith("test.json: "), refused::getMessage);
  }

  @Test
  void aFileThatIsNotJsonIsRefused() {
    assertThrows(IllegalStateException.class, () -> read("nonsense"));
    assertThrows(IllegalStateException.class, () -> read(""));
    assertThrows(IllegalStateException.class, () -> read("{\"dh\": ["));
  }

  @Test
  void limitsIncludeTheirEnds() {
    ArmDescription arm = ArmLibrary.load("ur5e");
    assertTrue(arm.withinLimits(Joints.ZERO.with(3, 2 * Math.PI)));
    assertFalse(arm.withinLimits(Joints.ZERO.with(3, 6.3)));
    assertFalse(arm.withinLimits(Joints.ZERO.with(5, Double.NaN)));
  }

  private static ArmDescription read(String json) {
    return new DescriptionReader(
            "test.json", new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)))
        .read();
  }
}
