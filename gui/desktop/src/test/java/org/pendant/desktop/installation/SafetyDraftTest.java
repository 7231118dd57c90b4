package org.pendant.desktop.installation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;

final class SafetyDraftTest {
  private static final ArmDescription ARM = ArmLibrary.load("ur5e");
  private static final SafetyConfiguration STANDARD = SafetyConfiguration.standard(ARM);

  private final ActiveInstallation active = new ActiveInstallation();
  private final SafetyDraft draft = new SafetyDraft(new Editing(active, () -> ARM));

  private static SafetyConfiguration slow() {
    return LimitsPage.withNormal(STANDARD, LimitKind.TOOL_SPEED.with(STANDARD.normal(), 0.5));
  }

  @Test
  void isLockedAtFirst() {
    draft.edit(slow());
    assertFalse(draft.unlocked());
    assertEquals(STANDARD, draft.shown());
  }

  @Test
  void nothingHoldsBeforeItIsApplied() {
    draft.unlock();
    draft.edit(slow());
    assertTrue(draft.changed());
    assertEquals(Installation.NONE, active.current());
    draft.apply();
    assertEquals(Optional.of(slow()), active.current().safety());
    assertFalse(draft.unlocked());
  }

  @Test
  void anotherConfigurationHasAnotherChecksum() {
    draft.unlock();
    draft.edit(slow());
    assertNotEquals(SafetyChecksum.of(STANDARD), draft.checksum());
  }

  @Test
  void lowerNormalLimitsLowerTheReducedOnes() {
    assertEquals(0.5, slow().reduced().toolSpeedMPerS());
  }

  @Test
  void tellsEachChange() {
    draft.unlock();
    draft.edit(slow());
    assertEquals(
        List.of("Normal tool speed: 1500 to 500 mm/s", "Reduced tool speed: 750 to 500 mm/s"),
        draft.changes());
  }

  @Test
  void tellsChangesOfJointsByTheNamesThatTheFormHas() {
    SafetyLimits normal = STANDARD.normal();
    SafetyLimits narrower =
        LimitKind.limits(
            LimitKind.values(normal),
            normal.jointSpeedRadPerS().with(3, 1),
            normal.jointMinRad().with(2, Math.toRadians(-130)),
            normal.jointMaxRad());
    draft.unlock();
    draft.edit(LimitsPage.withNormal(STANDARD, narrower));
    assertEquals(
        List.of(
            "Normal elbow range: [-363, 363] deg to [-130, 363] deg",
            "Normal wrist 1 speed: 190.8 to 57.296 deg/s",
            "Reduced elbow range: [-363, 363] deg to [-130, 363] deg",
            "Reduced wrist 1 speed: 95.4 to 57.296 deg/s"),
        draft.changes());
  }

  @Test
  void theStandardConfigurationIsNotWritten() {
    active.set(Installation.NONE.withSafety(Optional.of(slow())));
    draft.unlock();
    draft.edit(STANDARD);
    draft.apply();
    assertEquals(Optional.empty(), active.current().safety());
  }

  @Test
  void anotherConfigurationFromElsewhereEndsTheDraft() {
    draft.unlock();
    draft.edit(slow());
    active.set(
        Installation.NONE.withSafety(
            Optional.of(
                LimitsPage.withNormal(
                    STANDARD, LimitKind.TOOL_SPEED.with(STANDARD.normal(), 0.25)))));
    assertFalse(draft.unlocked());
    assertEquals(0.25, draft.shown().normal().toolSpeedMPerS());
  }

  @Test
  void limitsBeyondTheArmAreShownAsTheArmHasThem() {
    active.set(
        Installation.NONE.withSafety(
            Optional.of(SafetyConfiguration.standard(ArmLibrary.load("ur3e")))));
    assertEquals(Math.PI + 0.2, draft.shown().normal().jointSpeedRadPerS().get(3), 1e-9);
  }

  @Test
  void refusesToTypeALimitBeyondTheArm() {
    SafetyLimits normal = STANDARD.normal();
    SafetyLimits faster =
        LimitKind.limits(
            LimitKind.values(normal),
            normal.jointSpeedRadPerS().with(3, 6),
            normal.jointMinRad(),
            normal.jointMaxRad());
    assertTrue(
        draft
            .refusal(STANDARD.withLimits(faster, STANDARD.reduced()))
            .startsWith("joint 3 may turn at 6.0 rad/s, must be at most 3.34"));
  }

  @Test
  void whatIsTypedIsProposedUntilItIsGone() {
    draft.unlock();
    assertEquals(Optional.empty(), draft.proposed());

    assertEquals("", draft.refusal(slow()));
    assertEquals(Optional.of(slow()), draft.proposed());
    assertFalse(draft.changed());

    draft.nothingTyped();
    assertEquals(Optional.empty(), draft.proposed());
  }

  @Test
  void whatCannotBeIsNotProposed() {
    draft.unlock();
    draft.edit(slow());
    SafetyLimits normal = STANDARD.normal();
    SafetyLimits faster =
        LimitKind.limits(
            LimitKind.values(normal),
            normal.jointSpeedRadPerS().with(3, 6),
            normal.jointMinRad(),
            normal.jointMaxRad());

    assertFalse(draft.refusal(STANDARD.withLimits(faster, STANDARD.reduced())).isEmpty());

    assertEquals(Optional.of(slow()), draft.proposed());
  }

  @Test
  void nothingIsProposedWhileItIsLocked() {
    assertEquals("", draft.refusal(slow()));
    assertEquals(Optional.empty(), draft.proposed());
  }
}
