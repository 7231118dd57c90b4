package org.pendant.desktop.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.debug.Favourites;
import org.pendant.desktop.debug.HiddenNames;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
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
            new NoRun() {
              @Override
              public Optional<String> next() {
                return Optional.of(next);
              }
            },
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
}
