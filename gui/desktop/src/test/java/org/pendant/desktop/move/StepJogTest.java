package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.jog.JogDirection;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/** Moves by steps of that screen. */
final class StepJogTest extends MoveFixture {
  @Test
  void stepsAddUpHoweverFastTheyFollowEachOther() {
    refresh(1);
    double before = controller.state().arm().targetTcpInBase().z();
    presenter.jog().setSize(JogSize.MEDIUM);
    for (int i = 0; i < 5; i++) {
      presenter.jog().move(JogDirection.along(0, 0, 1));
      presenter.jog().letGo();
      refresh(2);
    }
    refresh(60);
    assertEquals(before + 0.005, controller.state().arm().targetTcpInBase().z(), 1e-6);
    assertFalse(controller.state().arm().moving());
    assertEquals(new ManualCommand.StopJog(), sent.getLast());
  }

  @Test
  void aStepLeadsToItsGoalThoughTheScreenHangsOnTheWay() {
    refresh(1);
    presenter.jog().setSize(JogSize.COARSE);
    presenter.jog().setSpeedFraction(0.1);
    Pose before = controller.state().arm().targetTcpInBase();
    presenter.jog().move(JogDirection.along(0, 0, -1));
    refresh(1);
    controller.runUntil(() -> false, 300);
    Pose stopped = controller.state().arm().targetTcpInBase();
    assertTrue(before.z() - stopped.z() < 0.0099, "it stops on the way, at " + stopped);
    refresh(60);
    assertEquals(before.z() - 0.01, controller.state().arm().targetTcpInBase().z(), 1e-6);
    assertFalse(controller.state().arm().moving());
  }

  @Test
  void aStepTurnsAJointByItsSize() {
    refresh(1);
    presenter.jog().setSize(JogSize.COARSE);
    presenter.jog().turn(0, 1);
    presenter.jog().letGo();
    refresh(100);
    assertEquals(Math.toRadians(10), position().get(0), 1e-12);
  }

  @Test
  void stepsAreRoundNumbersOfTheUnitsThatPeopleRead() {
    FormMemory.write(
        settings, new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.ROLL_PITCH_YAW));
    refresh(1);
    presenter.jog().setSize(JogSize.MEDIUM);
    presenter.jog().turn(0, 1);
    presenter.jog().letGo();
    refresh(100);
    assertEquals(0.02, position().get(0), 1e-12);
    double before = controller.state().arm().targetTcpInBase().z();
    presenter.jog().move(JogDirection.along(0, 0, 1));
    presenter.jog().letGo();
    refresh(100);
    assertEquals(before + 0.05 * 0.0254, controller.state().arm().targetTcpInBase().z(), 1e-6);
  }

  @Test
  void sizesOfStepsHaveTwoNumbersWhereOneDoesNotStandForLengthsAndAngles() {
    assertEquals("0.1", JogSize.FINE.title(PoseForm.STANDARD));
    assertEquals(
        "Move by 0.1 mm or turn by 0.1 deg at each press", JogSize.FINE.meaning(PoseForm.STANDARD));
    PoseForm inches = new PoseForm(DisplayUnit.INCH, DisplayUnit.DEGREE, RotationForm.VECTOR);
    assertEquals("0.5, 10", JogSize.COARSE.title(inches));
    assertEquals("Move by 0.5 in or turn by 10 deg at each press", JogSize.COARSE.meaning(inches));
  }

  @Test
  void aStepAlongTheToolFollowsItsAxes() {
    refresh(1);
    Pose before = controller.state().arm().targetTcpInBase();
    presenter.jog().setAxes(JogAxes.TOOL);
    presenter.jog().setSize(JogSize.COARSE);
    presenter.jog().move(JogDirection.along(0, 0, 1));
    refresh(100);
    Pose expected = Poses.trans(before, new Pose(0, 0, 0.01, 0, 0, 0));
    assertEquals(0, Poses.distance(expected, controller.state().arm().targetTcpInBase()), 1e-6);
  }

  @Test
  void aStepBeyondTheRangeOfAJointIsToldAndNotDone() {
    controller =
        new Controller(
            ControllerOptions.headless()
                .withStart(BoxSetup.START_RAD.with(5, Math.toRadians(362.5))));
    refresh(1);
    presenter.jog().setSize(JogSize.MEDIUM);
    presenter.jog().turn(5, 1);
    assertEquals("Wrist 3 is at the end of its range", presenter.jog().reason());
    assertEquals(List.of(), sent);
  }

  @Test
  void anArmOnItsWayThroughAStepStopsWhenTheScreenIsLeft() {
    refresh(1);
    presenter.jog().setSpeedFraction(0.1);
    presenter.jog().setSize(JogSize.COARSE);
    presenter.jog().turn(0, 1);
    presenter.jog().letGo();
    refresh(5);
    presenter.jog().release();
    refresh(20);
    assertTrue(position().get(0) > 0 && position().get(0) < Math.toRadians(9));
  }
}
