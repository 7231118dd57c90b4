package org.pendant.gui.shell.bar;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.machine.ProgramState;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.gui.session.Words;
import org.pendant.gui.shell.look.Badge;
import org.pendant.gui.workbench.Palette;
import org.pendant.models.arm.ArmLibrary;

/** Which program and robot this is, and the modes. */
@SuppressWarnings("serial") // never written to a stream
public final class Header extends JPanel {
  /** Room for the name of the program, in pixels before scaling. */
  private static final int PROGRAM_WIDTH = 160;

  private final JLabel program = new JLabel();
  private final JComboBox<RobotChoice> robot = new JComboBox<>();
  private final Badge robotMode = new Badge("robot-mode", "Robot mode");
  private final Badge safetyMode = new Badge("safety-mode", "Safety mode");
  private final Badge programState = new Badge("program-state", "Program state");
  private final JLabel time = new JLabel();
  private boolean showing;

  /** An arm that can be chosen. */
  private record RobotChoice(String id, String title) {
    @Override
    public String toString() {
      return title;
    }
  }

  /**
   * A header.
   *
   * @param chooseRobot told the id of the robot that was chosen
   */
  public Header(Consumer<String> chooseRobot) {
    super(
        new MigLayout(
            "insets 8 12 8 12, gap 8", "[0::, grow, fill]16[]16[][][]16[right]", "[center]"));
    setName("header");
    program.setName("program-name");
    program.putClientProperty("FlatLaf.styleClass", "h3");
    program.getAccessibleContext().setAccessibleName("Open program");
    robot.setName("robot");
    robot.setToolTipText("The simulated robot; another one starts a new controller");
    robot.getAccessibleContext().setAccessibleName("Robot");
    ArmLibrary.ids().forEach(id -> robot.addItem(new RobotChoice(id, title(id))));
    robot.setMaximumRowCount(ArmLibrary.ids().size());
    robot.addActionListener(
        event -> {
          if (!showing && robot.getSelectedItem() instanceof RobotChoice choice) {
            chooseRobot.accept(choice.id());
          }
        });
    time.setName("robot-time");
    time.putClientProperty("FlatLaf.styleClass", "monospaced");
    time.setToolTipText("Robot time since the controller was switched on");
    time.getAccessibleContext().setAccessibleName("Robot time");
    add(program, "wmin 0");
    add(robot);
    add(robotMode);
    add(safetyMode);
    add(programState);
    add(time);
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            fit();
          }
        });
  }

  @Override
  public void updateUI() {
    super.updateUI();
    EventQueue.invokeLater(
        () -> {
          if (time != null) {
            fit();
          }
        });
  }

  /** Leaves out what is shown elsewhere too where not everything fits. */
  private void fit() {
    time.setVisible(true);
    robotMode.setVisible(true);
    time.setVisible(fits());
    robotMode.setVisible(fits());
    revalidate();
  }

  private boolean fits() {
    MigLayout layout = (MigLayout) getLayout();
    layout.invalidateLayout(this);
    return layout.minimumLayoutSize(this).width + UIScale.scale(PROGRAM_WIDTH) <= getWidth();
  }

  private static String title(String id) {
    String model = id.substring(2).replace("long", " Long");
    return "UR" + model;
  }

  /** Shows which program is open. */
  public void show(ProgramDocument document) {
    program.setText(document.name() + (document.modified() ? " \u2022" : ""));
    program.setToolTipText(
        document.file().map(Object::toString).orElse("not saved yet")
            + (document.modified() ? ", modified" : ""));
  }

  /** Shows which robot there is. */
  public void showRobot(String id) {
    showing = true;
    for (int i = 0; i < robot.getItemCount(); i++) {
      if (robot.getItemAt(i).id().equals(id)) {
        robot.setSelectedIndex(i);
      }
    }
    showing = false;
  }

  /** Shows a snapshot. */
  public void refresh(ControllerState state) {
    RobotMode mode = state.safety().robotMode();
    robotMode.show("Robot " + Words.of(mode), color(mode));
    SafetyMode safety = state.safety().safetyMode();
    safetyMode.show(safetyText(safety), color(safety));
    ProgramState program = state.program().state();
    boolean held = state.debug().held();
    programState.show(
        held ? "Program held" : "Program " + Words.of(program),
        color(held ? ProgramState.PAUSED : program));
    String now = String.format(Locale.ROOT, "%8.1f s", state.timeS());
    if (!now.equals(time.getText())) {
      time.setText(now);
    }
  }

  private static String safetyText(SafetyMode mode) {
    return switch (mode) {
      case NORMAL, REDUCED, RECOVERY, FAULT, VIOLATION -> "Safety " + Words.of(mode);
      default -> Words.capital(Words.of(mode));
    };
  }

  private static Supplier<Color> color(RobotMode mode) {
    return switch (mode) {
      case RUNNING -> Palette::ok;
      case POWER_OFF -> Palette::quiet;
      default -> Palette::warning;
    };
  }

  private static Supplier<Color> color(SafetyMode mode) {
    return switch (mode) {
      case NORMAL -> Palette::ok;
      case REDUCED, RECOVERY, SAFEGUARD_STOP, AUTOMATIC_MODE_SAFEGUARD_STOP -> Palette::warning;
      default -> Palette::error;
    };
  }

  private static Supplier<Color> color(ProgramState state) {
    return switch (state) {
      case RUNNING -> Palette::ok;
      case PAUSED -> Palette::warning;
      case STOPPED -> Palette::quiet;
    };
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    g.setColor(Palette.line());
    g.drawLine(0, getHeight() - 1, getWidth(), getHeight() - 1);
  }
}
