package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import java.awt.Component;
import java.awt.Graphics;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.Pace;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.action.ActionButton;
import org.pendant.kit.action.ActionButtons;
import org.pendant.kit.action.ActionItem;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.layout.Squeeze;
import org.pendant.kit.theme.Palette;

/**
 * Footer: what is needed at any time: readiness, speed, the pace of time, and the program's
 * buttons.
 */
@SuppressWarnings("serial") // never written to a stream
public final class Footer extends JPanel {
  /** Layout of a button with its word, without it, and where there is hardly any room. */
  private static final String WORDED = "cell 4 0, wmin pref, h 36:36:";

  private static final String WORDLESS = "cell 4 0, w 44!, h 36:36:";
  private static final String TINY = "cell 4 0, w 34!, h 36:36:";
  private static final List<String> WORDS =
      List.of(text("run"), text("pause"), text("step"), text("stop"));

  private final transient RobotSession session;
  private final transient ActionTable actions;
  private final ReadinessBar readiness;
  private final SpeedSlider speed;
  private final JComboBox<PaceChoice> pace = new JComboBox<>();
  private final JButton more = new JButton(Glyph.MORE.icon(16));
  private final ActionButton run;
  private final ActionButton frameStep;
  private final List<ActionButton> buttons;
  private final ActionButtons buttonRow;
  private final transient MigLayout layout;
  private final transient Squeeze squeeze;
  private String constraints = WORDED;
  private String fitted = "";

  /**
   * A footer.
   *
   * @param send has the controller do something, and tells when it is refused
   */
  public Footer(RobotSession session, ActionTable actions, Consumer<Command> send) {
    super(
        new MigLayout(
            "insets 8 12 8 12, gap 8, hidemode 3",
            "[][grow, fill, :260:260][][]push[]",
            "[center]"));
    layout = (MigLayout) getLayout();
    this.session = session;
    this.actions = actions;
    setName("footer");
    readiness = new ReadinessBar(session.state(), send);
    speed =
        new SpeedSlider(
            percent -> session.submit(new BoxCommand.SetSpeedFraction(percent / 100.0)));
    setUpPace();
    frameStep = new ActionButton(actions, "clock.step-frame", "", Glyph.STEP.icon(16));
    run = new ActionButton(actions, "program.run", text("run"), Glyph.PLAY.icon(16, Palette.ok()));
    ActionButton pause =
        new ActionButton(actions, "program.pause", text("pause"), Glyph.PAUSE.icon(16));
    ActionButton step =
        new ActionButton(actions, "program.step", text("step"), Glyph.STEP.icon(16));
    ActionButton stop =
        new ActionButton(
            actions, "program.stop", text("stop"), Glyph.STOP.icon(16, Palette.error()));
    buttons = List.of(run, pause, step, stop);
    buttonRow = new ActionButtons(buttons);
    run.setComponentPopupMenu(runMenu());
    more.setName("footer-more");
    more.setToolTipText(text("speedPaceOfRobotTimeAnd"));
    more.getAccessibleContext().setAccessibleName(text("moreOfTheFooter"));
    more.putClientProperty("JButton.buttonType", "toolBarButton");
    more.addActionListener(
        event -> {
          JPopupMenu menu = moreMenu();
          menu.show(more, 0, -menu.getPreferredSize().height);
        });
    add(readiness, "cell 0 0");
    add(speed, "cell 1 0, growx");
    JPanel time = new JPanel(new MigLayout("insets 0, gap 4, hidemode 3", "[][]", "[center]"));
    time.add(pace);
    time.add(frameStep);
    add(time, "cell 2 0");
    add(more, "cell 3 0");
    buttons.forEach(each -> add(each, WORDED));
    squeeze =
        new Squeeze(
            this,
            List.of(
                whole -> more.setVisible(false),
                whole -> constrain(whole ? WORDED : WORDLESS),
                whole -> {
                  time.setVisible(whole);
                  more.setVisible(!whole);
                },
                readiness::showRemedy,
                speed::setVisible,
                whole -> constrain(whole ? constraints : TINY),
                whole -> {
                  step.setVisible(whole);
                  pause.setVisible(whole);
                },
                readiness::setVisible));
  }

  private void setUpPace() {
    PaceChoice.ALL.forEach(pace::addItem);
    pace.setName("pace");
    pace.setMaximumRowCount(PaceChoice.ALL.size());
    pace.setToolTipText(text("howFastRobotTimeGoesBy"));
    pace.getAccessibleContext().setAccessibleName(text("paceOfRobotTime"));
    pace.setPrototypeDisplayValue(PaceChoice.of(new Pace.Unlimited()));
    pace.setSelectedItem(PaceChoice.of(session.pace()));
    pace.addActionListener(
        event -> {
          if (pace.getSelectedItem() instanceof PaceChoice choice) {
            session.setPace(choice.pace());
          }
        });
  }

  /** The ways to start a program, by a click with the other button. */
  private JPopupMenu runMenu() {
    return new JPopupMenu() {
      @Override
      public void show(Component invoker, int x, int y) {
        removeAll();
        add(ActionItem.of(actions, "program.run"));
        add(ActionItem.of(actions, "program.run-from"));
        add(ActionItem.of(actions, "program.step"));
        super.show(invoker, 0, -getPreferredSize().height);
      }
    };
  }

  /** What the footer has no room for. */
  private JPopupMenu moreMenu() {
    JPopupMenu menu = new JPopupMenu();
    for (int percent : new int[] {100, 75, 50, 25, 10, 0}) {
      JMenuItem item =
          new JRadioButtonMenuItem(text("speedIs", percent), speed.percent() == percent);
      item.addActionListener(event -> speed.choose(percent));
      menu.add(item);
    }
    menu.addSeparator();
    for (PaceChoice each : PaceChoice.ALL) {
      JMenuItem item =
          new JRadioButtonMenuItem(
              text("robotTimeIs", each.title()), each.pace().equals(session.pace()));
      item.addActionListener(event -> session.setPace(each.pace()));
      menu.add(item);
    }
    menu.addSeparator();
    for (String id :
        List.of(
            "clock.step-frame",
            "robot.ready",
            "program.run-from",
            "program.pause",
            "program.step")) {
      menu.add(ActionItem.of(actions, id));
    }
    return menu;
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (squeeze != null) {
      squeeze.fitLater();
    }
  }

  private void constrain(String wanted) {
    constraints = wanted;
    for (int i = 0; i < WORDS.size(); i++) {
      buttons.get(i).setText(wanted.equals(WORDED) ? WORDS.get(i) : "");
      layout.setComponentConstraints(buttons.get(i), wanted);
    }
    if (wanted.equals(WORDED)) {
      showRun(session.state());
    }
  }

  /** Shows a snapshot. */
  public void refresh(ControllerState state) {
    readiness.refresh(state);
    speed.follow(state.arm().speedFraction());
    PaceChoice chosen = PaceChoice.of(session.pace());
    if (!chosen.equals(pace.getSelectedItem())) {
      pace.setSelectedItem(chosen);
    }
    frameStep.setVisible(chosen.pace() instanceof Pace.Paused);
    frameStep.refresh();
    showRun(state);
    buttonRow.refresh();
    String content = readiness.words() + frameStep.isVisible() + ProgramPhase.of(state);
    if (!content.equals(fitted)) {
      fitted = content;
      squeeze.fit();
    }
  }

  private void showRun(ControllerState state) {
    String word = ProgramPhase.of(state).runWord();
    if (constraints.equals(WORDED) && !word.equals(run.getText())) {
      run.setText(word);
    }
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    g.setColor(Palette.line());
    g.drawLine(0, 0, getWidth(), 0);
  }
}
