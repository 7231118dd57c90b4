package org.pendant.desktop.program.form;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.event.KeyEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.theme.PreviewLook;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.check.NodeProblem;

/** Forms in a real window, as far as there is a display. */
@Tag("slow")
final class NodeFormsTest {
  private RobotSession session;
  private FakeHost host;
  private NodeForms forms;
  private JFrame frame;

  @BeforeEach
  void open() throws InterruptedException, InvocationTargetException {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    session = RobotSession.start(ControllerOptions.headless());
    EventQueue.invokeAndWait(
        () -> {
          PreviewLook.install(false);
          host = new FakeHost(EveryNode.tree(session.state()), session.state());
          host.setInstallation(EveryNode.installation());
          forms = new NodeForms(new PreviewWorkbench(session), host);
          frame = new JFrame("Forms");
          frame.add(forms.component());
          frame.setSize(420, 900);
          frame.setVisible(true);
        });
  }

  @AfterEach
  void close() throws InterruptedException, InvocationTargetException {
    if (session != null) {
      EventQueue.invokeAndWait(frame::dispose);
      session.close();
    }
  }

  private ProgramNode first(Class<?> step) {
    return host.tree().nodes().stream()
        .filter(each -> step.isInstance(each.step()))
        .findFirst()
        .orElseThrow();
  }

  /** Shows a node, and again whenever the program changes, as the screen around does. */
  private void show(ProgramNode node) throws InterruptedException, InvocationTargetException {
    long key = node.key();
    host.whenChanged(() -> forms.show(host.tree().find(key)));
    EventQueue.invokeAndWait(() -> forms.show(Optional.of(node)));
    settle();
  }

  /** What was asked for later has been done. */
  private static void settle() throws InterruptedException, InvocationTargetException {
    for (int i = 0; i < 3; i++) {
      EventQueue.invokeAndWait(() -> {});
    }
  }

  private static Component find(Container in, String name) {
    for (Component each : in.getComponents()) {
      if (name.equals(each.getName())) {
        return each;
      }
      if (each instanceof Container inner) {
        Component found = find(inner, name);
        if (found != null) {
          return found;
        }
      }
    }
    return null;
  }

  private <C> C control(String name, Class<C> type) {
    return type.cast(find(forms.component(), name));
  }

  private MotionStep.Move move() {
    return (MotionStep.Move) first(MotionStep.Move.class).step();
  }

  private static void type(JTextField field, String text)
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(() -> field.setText(text));
    settle();
  }

  private static void press(JComponent control, int key)
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () ->
            control.dispatchEvent(
                new KeyEvent(control, KeyEvent.KEY_PRESSED, 0, 0, key, KeyEvent.CHAR_UNDEFINED)));
    settle();
  }

  @Test
  void theFirstNodeIsInTheFirstPicture() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          forms.show(Optional.of(first(MotionStep.Move.class)));
          assertNotNull(control("form-move-speed", JTextField.class));
        });
  }

  @Test
  void typingChangesTheProgramAtOnce() throws InterruptedException, InvocationTargetException {
    show(first(MotionStep.Move.class));
    JTextField speed = control("form-move-speed", JTextField.class);
    type(speed, "90");
    assertEquals(Math.PI / 2, move().speed(), 1e-9);
    assertNull(speed.getClientProperty("JComponent.outline"));
  }

  @Test
  void whatCannotBeTakenStaysRedWithTheReason()
      throws InterruptedException, InvocationTargetException {
    show(first(MotionStep.Move.class));
    JTextField speed = control("form-move-speed", JTextField.class);
    double before = move().speed();
    type(speed, "quick");
    assertEquals("quick", speed.getText());
    assertEquals("error", speed.getClientProperty("JComponent.outline"));
    assertEquals(
        "'quick' is not a number in deg/s",
        control("form-move-speed-problem", JTextComponent.class).getText());
    assertEquals(before, move().speed());
  }

  @Test
  void theUnitOfANumberStaysInSightWhereTheFormIsNarrow()
      throws InterruptedException, InvocationTargetException {
    show(first(MotionStep.Move.class));
    EventQueue.invokeAndWait(
        () -> {
          frame.setSize(256, 900);
          frame.validate();
        });
    settle();
    EventQueue.invokeAndWait(
        () -> {
          JTextField field = control("form-move-speed", JTextField.class);
          Container row = field.getParent();
          Component unit = row.getComponent(1);
          assertEquals("deg/s", ((JLabel) unit).getText());
          assertTrue(unit.getX() + unit.getWidth() <= row.getWidth(), () -> unit + " in " + row);
          assertTrue(field.getWidth() > 40, () -> "room for some digits: " + field.getWidth());
        });
  }

  @Test
  void enterTidiesWhatWasTyped() throws InterruptedException, InvocationTargetException {
    show(first(MotionStep.Move.class));
    JTextField speed = control("form-move-speed", JTextField.class);
    type(speed, "90,50 deg/s");
    press(speed, KeyEvent.VK_ENTER);
    assertEquals("90.5", speed.getText());
  }

  @Test
  void fieldsFollowUndoAndKeepTheirCaretOtherwise()
      throws InterruptedException, InvocationTargetException {
    show(first(MotionStep.Move.class));
    JTextField speed = control("form-move-speed", JTextField.class);
    EventQueue.invokeAndWait(speed::requestFocusInWindow);
    type(speed, "45");
    EventQueue.invokeAndWait(() -> speed.setCaretPosition(1));
    EventQueue.invokeAndWait(() -> host.change("Other", host.tree().withInstallation("other")));
    settle();
    assertEquals(1, speed.getCaretPosition());
    EventQueue.invokeAndWait(
        () -> {
          host.undo();
          host.undo();
        });
    settle();
    assertEquals("60", speed.getText());
  }

  @Test
  void anotherNodeHasFieldsOfItsOwn() throws InterruptedException, InvocationTargetException {
    show(first(MotionStep.Move.class));
    type(control("form-move-speed", JTextField.class), "quick");
    show(first(MotionStep.Home.class));
    show(first(MotionStep.Move.class));
    assertEquals("60", control("form-move-speed", JTextField.class).getText());
  }

  @Test
  void changingTheKindKeepsTheControlsThatFit()
      throws InterruptedException, InvocationTargetException {
    show(first(MotionStep.Move.class));
    JComboBox<?> feature = control("form-move-feature", JComboBox.class);
    EventQueue.invokeAndWait(
        () -> control("form-move-kind-LINEAR", AbstractButton.class).doClick(0));
    settle();
    assertSame(feature, control("form-move-feature", JComboBox.class));
    assertEquals("250", control("form-move-speed", JTextField.class).getText());
  }

  @Test
  void problemsOfTheCheckStandAtTheirFields()
      throws InterruptedException, InvocationTargetException {
    ProgramNode node = first(MotionStep.Move.class);
    host.addProblem(new NodeProblem(node.key(), "tool", "is missing"));
    host.addProblem(new NodeProblem(node.key(), "", "does not belong here"));
    show(node);
    assertEquals("is missing", control("form-move-tool-problem", JTextComponent.class).getText());
    assertEquals("does not belong here", control("form-problems", JTextComponent.class).getText());
  }

  @Test
  void warningsOfTheScriptStandBelowTheTitle()
      throws InterruptedException, InvocationTargetException {
    ProgramNode node = first(MotionStep.Move.class);
    host.addWarning(new NodeProblem(node.key(), "", "this loop never waits", false));
    show(node);
    assertEquals("this loop never waits", control("form-warnings", JTextComponent.class).getText());
    assertEquals("", control("form-problems", JTextComponent.class).getText());
  }

  @Test
  void everyControlOfEveryFormHasANameForScreenReaders()
      throws InterruptedException, InvocationTargetException {
    for (ProgramNode node : host.tree().nodes()) {
      show(node);
      EventQueue.invokeAndWait(() -> checkNames(forms.component(), node));
    }
  }

  private static void checkNames(Container in, ProgramNode node) {
    for (Component each : in.getComponents()) {
      boolean control =
          each instanceof JTextField
              || each instanceof AbstractButton
              || each instanceof JComboBox<?>;
      if (control && each.isFocusable() && each.getName() != null) {
        String words = each.getAccessibleContext().getAccessibleName();
        assertFalse(words == null || words.isBlank(), node.step() + " " + each.getName());
        assertTrue(each.getName().startsWith("form-"), each.getName());
      }
      if (each instanceof Container inner) {
        checkNames(inner, node);
      }
    }
  }
}
