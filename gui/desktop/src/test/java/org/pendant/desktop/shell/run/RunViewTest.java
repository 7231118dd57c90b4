package org.pendant.desktop.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Stream;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.debug.Favourites;
import org.pendant.desktop.debug.HiddenNames;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.RunTime;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.kit.layout.Parts;
import org.pendant.kit.theme.Look;
import org.pendant.kit.theme.Theme;

/** The screen, in no window. */
final class RunViewTest {
  private static final int WIDTH = 720;
  private static final int HEIGHT = 700;

  private final RobotSession session = RobotSession.start(ControllerOptions.headless());
  private final PreviewWorkbench workbench = new PreviewWorkbench(session);
  private String next = "pick.script";
  private RunView view;

  @BeforeEach
  void readRadians() {
    FormMemory.write(
        workbench.settings(),
        new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.ROLL_PITCH_YAW));
  }

  @AfterEach
  void end() {
    session.close();
  }

  @Test
  void theFirstPictureHasItsPartsWhereTheyStay() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          open();
          assertFalse(part("run-waiting").isVisible());
          assertEquals(
              List.of("X", "Y", "Z", "Roll", "Pitch", "Yaw"),
              Stream.of(((Container) part("run-tcp")).getComponents())
                  .filter(each -> each.getName() == null)
                  .map(each -> ((JLabel) each).getText())
                  .skip(1)
                  .toList());
          int program = part("run-program").getPreferredSize().height;
          int joints = part("run-joints").getPreferredSize().height;
          view.refresh(session.state());
          assertEquals(program, part("run-program").getPreferredSize().height);
          assertEquals(joints, part("run-joints").getPreferredSize().height);
        });
  }

  @Test
  void numbersHaveTheirWidthBesideALongName() throws Exception {
    next = "a_program_with_a_name_that_nobody_would_ever_type_twice_without_a_mistake.script";
    EventQueue.invokeAndWait(
        () -> {
          open();
          layOut();
          Component joints = part("run-joints");
          assertTrue(
              joints.getWidth() >= joints.getPreferredSize().width,
              () -> joints.getWidth() + " of " + joints.getPreferredSize().width);
        });
  }

  private void open() {
    Look look = new Look(workbench.settings());
    look.loadFonts();
    look.install();
    look.setTheme(Theme.LIGHT);
    view =
        new RunView(
            workbench,
            workbench.actions(),
            new Idle(),
            command -> {},
            new Favourites(workbench.settings()),
            new HiddenNames(workbench.settings()),
            timeS -> {});
  }

  private void layOut() {
    view.component().setSize(WIDTH, HEIGHT);
    Parts.layOut(view.component());
    view.refresh(session.state());
    invalidate(view.component());
    Parts.layOut(view.component());
  }

  /** What a text does in a window when it changes. */
  private static void invalidate(Container in) {
    in.invalidate();
    for (Component each : in.getComponents()) {
      if (each instanceof Container inner) {
        invalidate(inner);
      }
    }
  }

  private Component part(String name) {
    return Parts.named(view.component(), name);
  }

  /** No program has run yet. */
  private final class Idle implements RunProgram {
    @Override
    public Optional<String> next() {
      return Optional.of(next);
    }

    @Override
    public String name(ControllerState state) {
      return "";
    }

    @Override
    public boolean left(ControllerState state) {
      return false;
    }

    @Override
    public Optional<List<LogEntry>> recordedLog() {
      return Optional.empty();
    }

    @Override
    public Optional<RunNode> nodeAt(int line) {
      return Optional.empty();
    }

    @Override
    public RunTime time() {
      return RunTime.NONE;
    }

    @Override
    public String lineText(int line) {
      return "";
    }

    @Override
    public int shownLine(int line) {
      return line;
    }

    @Override
    public void showLine(int line) {}

    @Override
    public Optional<RunNode> node(ControllerState state) {
      return Optional.empty();
    }

    @Override
    public void show(RunNode node) {}

    @Override
    public OptionalLong turns(ControllerState state) {
      return OptionalLong.empty();
    }

    @Override
    public List<InstallationVariable> installationVariables() {
      return List.of();
    }
  }
}
