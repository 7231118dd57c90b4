package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.lang.reflect.InvocationTargetException;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.BoxCommand;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;

final class IoViewTest {
  private RobotSession session;
  private PreviewWorkbench workbench;

  @BeforeEach
  void start() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    session = RobotSession.start(ControllerOptions.headless());
    workbench = new PreviewWorkbench(session);
  }

  @AfterEach
  void close() {
    if (session != null) {
      session.close();
    }
  }

  /** Work on the dispatch thread with the view in a window. */
  private interface Work {
    void on(IoView view);
  }

  private void show(Work work) throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          FlatLaf.setup(new FlatLightLaf());
          IoView view = new IoView(workbench);
          JFrame frame = new JFrame(view.title());
          frame.add(view.component());
          frame.setSize(1024, 700);
          frame.setVisible(true);
          try {
            view.refresh(session.state());
            work.on(view);
          } finally {
            frame.dispose();
          }
        });
  }

  /** Waits for the frames that carry out what was asked, and shows what they made of it. */
  private void settle(IoView view) {
    session.submit(new BoxCommand.SetSpeedFraction(1)).join();
    view.refresh(session.state());
  }

  private static <C extends Component> C find(Container in, String name, Class<C> kind) {
    return search(in, name, kind).orElseThrow(() -> new AssertionError("there is no " + name));
  }

  private static <C extends Component> Optional<C> search(
      Container in, String name, Class<C> kind) {
    for (Component each : in.getComponents()) {
      if (name.equals(each.getName())) {
        return Optional.of(kind.cast(each));
      }
      if (each instanceof Container inner) {
        Optional<C> found = search(inner, name, kind);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }

  @Test
  void anAnalogInputIsForcedBySliderAndField()
      throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          find(view.component(), "analog-in-1", JSlider.class).setValue(250);
          settle(view);
          assertEquals(2.5, session.state().signals().analog().standardIn1().value());
          JTextField field = find(view.component(), "analog-in-1-value", JTextField.class);
          field.setText("11");
          field.postActionEvent();
          assertEquals(
              "'11' must be 0 to 10 V",
              find(view.component(), "analog-in-1-problem", JLabel.class).getText());
          field.setText("7.5");
          field.postActionEvent();
          settle(view);
          assertEquals(7.5, session.state().signals().analog().standardIn1().value());
        });
  }

  @Test
  void forcedInputsAreCountedAndReleased() throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          JLabel forced = find(view.component(), "io-forced", JLabel.class);
          AbstractButton release = find(view.component(), "io-release-all", AbstractButton.class);
          assertEquals("No input forced", forced.getText());
          assertFalse(release.isEnabled());
          AbstractButton input = find(view.component(), "digital-in-3", AbstractButton.class);
          Point place = SwingUtilities.convertPoint(input, 0, 0, view.component());
          input.doClick(0);
          find(view.component(), "tool-analog-in-0", JSlider.class).setValue(1000);
          settle(view);
          assertEquals("2 inputs forced", forced.getText());
          assertTrue(release.isEnabled());
          view.component().validate();
          assertEquals(place, SwingUtilities.convertPoint(input, 0, 0, view.component()));
          workbench.actions().run("io.release-all");
          settle(view);
          assertEquals(0, session.state().io().standardIn());
          assertFalse(release.isEnabled());
        });
  }

  @Test
  void aRegisterIsFoundAndSet() throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          find(view.component(), "io-register-search", JTextField.class).setText("24");
          JTable table = find(view.component(), "io-integer-input-registers", JTable.class);
          assertEquals(1, table.getRowCount());
          table.editCellAt(0, MemoryTableModel.VALUE);
          JTextField field =
              find(view.component(), "io-integer-input-registers-field", JTextField.class);
          field.setText("1.5");
          assertFalse(table.getCellEditor().stopCellEditing(), "what is wrong stays in the field");
          field.setText("42");
          assertTrue(table.getCellEditor().stopCellEditing());
          settle(view);
          assertEquals(42, session.state().signals().inputs().integer(24));
          assertEquals("42", table.getValueAt(0, MemoryTableModel.VALUE));
        });
  }

  @Test
  void outputsAreSwitchesUntilAProgramRuns()
      throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          AbstractButton output = find(view.component(), "digital-out-4", AbstractButton.class);
          output.doClick(0);
          settle(view);
          assertEquals(1 << 4, session.state().io().standardOut());
          session
              .run(TestController.program(session.robot(), "def busy():\n  sleep(60)\nend\n"))
              .join();
          settle(view);
          assertFalse(output.isEnabled());
          assertTrue(output.isSelected());
          session.submit(new ProgramCommand.StopProgram()).join();
        });
  }
}
