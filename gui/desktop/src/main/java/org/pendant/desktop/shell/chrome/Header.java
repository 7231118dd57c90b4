package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Rectangle;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.event.PopupMenuEvent;
import javax.swing.event.PopupMenuListener;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.StateWords;
import org.pendant.kit.layout.Squeeze;
import org.pendant.kit.theme.Badge;
import org.pendant.kit.theme.Palette;
import org.pendant.models.arm.ArmLibrary;

/** Header: which program and robot this is, and the modes. */
@SuppressWarnings("serial") // never written to a stream
public final class Header extends JPanel {
  private final ProgramButton program;
  private final JComboBox<RobotChoice> robot = new JComboBox<>();
  private final Badge robotMode = new Badge("robot-mode", text("robotMode"));
  private final Badge safetyMode = new Badge("safety-mode", text("safetyMode"));
  private final Badge checksum =
      new Badge("safety-checksum", text("checksumOfTheSafetyConfiguration"));
  private final Badge programState = new Badge("program-state", text("programState"));
  private final JLabel time = new SteadyLabel();
  private final transient Squeeze squeeze;
  private transient ControllerState state;
  private boolean showing;

  /** Id of the robot that there is. */
  private String there = "";

  private boolean worded = true;
  private transient List<Object> fitted = List.of();

  /** An arm that can be chosen. */
  private record RobotChoice(String id, String title) {
    @Override
    public String toString() {
      return title;
    }
  }

  /** A label whose text is always as wide: nothing around it need be laid out for another one. */
  private static final class SteadyLabel extends JLabel {
    @Override
    public boolean isValidateRoot() {
      return true;
    }
  }

  /**
   * A header.
   *
   * @param menu of the programs, opened by the name of the present one
   * @param chooseRobot told the id of the robot that was chosen
   */
  public Header(ProgramMenu menu, Consumer<String> chooseRobot) {
    super(
        new MigLayout(
            "insets 8 6 8 12, gap 8, hidemode 3",
            "[grow, 90::]16[]16[][][][]16[right]",
            "[center]"));
    setName("header");
    program = new ProgramButton(menu);
    robot.setName("robot");
    robot.setToolTipText(text("theSimulatedRobotAnotherOneStarts"));
    robot.getAccessibleContext().setAccessibleName(text("robot"));
    ArmLibrary.ids().forEach(id -> robot.addItem(new RobotChoice(id, title(id))));
    robot.setMaximumRowCount(ArmLibrary.ids().size());
    robot.addActionListener(
        event -> {
          // an arrow key in the open list only looks at one; it counts when the list closes
          if (!showing && !robot.isPopupVisible()) {
            chosen(chooseRobot);
          }
        });
    robot.addPopupMenuListener(
        new PopupMenuListener() {
          @Override
          public void popupMenuWillBecomeVisible(PopupMenuEvent event) {}

          @Override
          public void popupMenuWillBecomeInvisible(PopupMenuEvent event) {
            EventQueue.invokeLater(() -> chosen(chooseRobot));
          }

          @Override
          public void popupMenuCanceled(PopupMenuEvent event) {
            showRobot(there);
          }
        });
    checksum.setToolTipText(text("checksumOfTheSafetyConfigurationEqual"));
    time.setName("robot-time");
    time.setText(clock(0));
    time.putClientProperty("FlatLaf.styleClass", "monospaced");
    time.setToolTipText(text("robotTimeSinceTheControllerWas"));
    time.getAccessibleContext().setAccessibleName(text("robotTime"));
    add(program, "wmin 90");
    for (JComponent each : List.of(robot, robotMode, safetyMode, checksum, programState, time)) {
      add(each, "wmin pref");
    }
    // What vanishes is shown or done elsewhere too; the safety mode stays.
    squeeze =
        new Squeeze(
            this,
            List.of(
                time::setVisible,
                checksum::setVisible,
                this::showWords,
                robotMode::setVisible,
                robot::setVisible,
                programState::setVisible));
  }

  private void showWords(boolean whole) {
    worded = whole;
    if (state != null) {
      showModes(state);
    }
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (squeeze != null) {
      squeeze.fitLater();
    }
  }

  private static String title(String id) {
    String model = id.substring(2).replace("long", " Long");
    return "UR" + model;
  }

  /** Shows which program is open. */
  public void show(ProgramDocument document) {
    program.show(document);
  }

  /** Opens the menu of programs. */
  public void openPrograms() {
    program.open();
  }

  private void chosen(Consumer<String> chooseRobot) {
    if (robot.getSelectedItem() instanceof RobotChoice choice && !choice.id().equals(there)) {
      chooseRobot.accept(choice.id());
    }
  }

  /** Opens the list of robots. */
  public void openRobots() {
    JPopupMenu menu = new JPopupMenu();
    menu.setName("robot-menu");
    for (int i = 0; i < robot.getItemCount(); i++) {
      int index = i;
      JMenuItem item =
          new JRadioButtonMenuItem(robot.getItemAt(i).title(), i == robot.getSelectedIndex());
      item.addActionListener(event -> robot.setSelectedIndex(index));
      menu.add(item);
    }
    Rectangle place = robot.isShowing() ? robot.getBounds() : getVisibleRect();
    menu.show(this, place.x, place.y + place.height);
  }

  /** Shows which robot there is. */
  public void showRobot(String id) {
    there = id;
    showing = true;
    for (int i = 0; i < robot.getItemCount(); i++) {
      if (robot.getItemAt(i).id().equals(id)) {
        robot.setSelectedIndex(i);
      }
    }
    showing = false;
  }

  /** Shows a snapshot. */
  public void refresh(ControllerState now) {
    state = now;
    showModes(now);
    List<Object> modes =
        List.of(
            now.safety().robotMode(),
            now.safety().safetyMode(),
            now.safety().checksum(),
            ProgramPhase.of(now));
    if (!modes.equals(fitted)) {
      fitted = modes;
      squeeze.fit();
    }
    String clock = clock(now.timeS());
    if (!clock.equals(time.getText())) {
      time.setText(clock);
    }
  }

  private static String clock(double timeS) {
    return String.format(Locale.ROOT, "%8.1f s", timeS);
  }

  private void showModes(ControllerState now) {
    RobotMode mode = now.safety().robotMode();
    robotMode.show(words("robotIs", StateWords.of(mode)), color(mode));
    SafetyMode safety = now.safety().safetyMode();
    safetyMode.show(safetyText(safety), color(safety));
    checksum.show(now.safety().checksum().toString(), Palette::quiet);
    ProgramPhase program = ProgramPhase.of(now);
    programState.show(words("programIs", program.word()), color(program));
  }

  private String words(String key, String how) {
    return worded ? text(key, how) : StateWords.capital(how);
  }

  private String safetyText(SafetyMode mode) {
    return switch (mode) {
      case NORMAL, REDUCED, RECOVERY, FAULT, VIOLATION -> words("safetyIs", StateWords.of(mode));
      default -> StateWords.capital(StateWords.of(mode));
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

  private static Supplier<Color> color(ProgramPhase phase) {
    return switch (phase) {
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
