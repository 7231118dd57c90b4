package org.pendant.recording.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.FrictionCurve;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Gravity;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.identification.LoadFit;
import org.pendant.recording.compare.Samples;
import org.pendant.script.vm.ProgramState;

class ArmFitTest {
  private static final String SWING =
      """
      def swing():
        movej([0.6, -1.0, -1.8, -0.6, 0.6, 0.9], a=3, v=1.5)
        movej([-0.6, -1.9, -0.8, -2.4, 2.4, -0.9], a=2, v=0.8)
        movej([0.2, -1.4, -1.4, -1.0, 1.0, 2.0], a=3, v=1.2)
      end
      """;

  private final ArmDescription arm = ArmLibrary.load("ur5e");

  /**
   * What a run of {@link #SWING} leaves of some quantities, every fourth frame; at first the drives
   * have no target yet.
   */
  private static Samples swing(String... names) {
    Controller controller = new Controller(ControllerOptions.headless());
    Samples.Builder samples =
        new Samples.Builder(Stream.of(names).map(StateQuantities::of).toList());
    samples.add(controller.state());
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, SWING)));
    do {
      for (int i = 0; i < 4; i++) {
        controller.advance();
      }
      samples.add(controller.state());
    } while (controller.state().program().state() != ProgramState.STOPPED);
    return samples.build();
  }

  private ArmDescription withoutFriction() {
    List<Actuator> drives = new ArrayList<>();
    arm.actuators().forEach(each -> drives.add(each.frictionless()));
    return arm.withActuators(drives);
  }

  private static ArmFit fit(ArmDescription model, Samples samples) {
    return ArmFit.of(
        model, Gravity.UPRIGHT, List.of(samples), Optional.of(Payload.NONE), Payload.NONE);
  }

  @Test
  void currentsOfTheDrivesAloneTellTheirFriction() {
    ArmFit fit = fit(withoutFriction(), swing("actual_q", "actual_qd", "current"));

    for (int i = 0; i < Joints.COUNT; i++) {
      FrictionCurve expected = arm.actuators().get(i).friction();
      FrictionCurve found = fit.arm().actuators().get(i).friction();
      assertEquals(
          expected.currentA(0.5, 0),
          found.currentA(0.5, 0),
          0.05 * expected.currentA(0.5, 0),
          "joint " + i);
    }
    assertEquals(Optional.empty(), fit.load());
    assertTrue(
        fit.notes().getFirst().startsWith("no moments of the target"), fit.notes()::toString);
    assertEquals(OptionalDouble.empty(), fit.joints().getFirst().lagS());
  }

  @Test
  void momentsAndCurrentsOfTheTargetGiveTheDescriptionBack() {
    ArmFit fit =
        fit(
            withoutFriction(),
            swing(
                "target_q",
                "target_qd",
                "target_qdd",
                "target_torque",
                "target_current",
                "actual_q"));

    for (int i = 0; i < Joints.COUNT; i++) {
      Actuator expected = arm.actuators().get(i);
      Actuator found = fit.arm().actuators().get(i);
      assertEquals(expected.rotorInertiaKgM2(), found.rotorInertiaKgM2(), 1e-3, "joint " + i);
      assertEquals(expected.lagS(), found.lagS(), 5e-5, "joint " + i);
      assertEquals(
          expected.friction().currentA(0.5, 0),
          found.friction().currentA(0.5, 0),
          2e-3,
          "joint " + i);
    }
  }

  @Test
  void momentsAreExplainedButForThoseOfDrivesWithoutATarget() {
    ArmFit fit =
        fit(arm, swing("target_q", "target_qd", "target_qdd", "target_torque", "target_current"));

    LoadFit.Found load = assertInstanceOf(LoadFit.Found.class, fit.load().orElseThrow());
    assertEquals(0, load.rmsBeforeNm(), 1e-9);
  }

  @Test
  void saysWhatARecordingLacks() {
    assertEquals(
        Optional.of("currents (target_current, or actual_current)"),
        ArmFit.lacks(List.of(swing("actual_q", "actual_qd"))));
    assertEquals(Optional.empty(), ArmFit.lacks(List.of(swing("actual_q", "current"))));
  }
}
