package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.StateWords;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.Actions;
import org.pendant.kit.theme.Palette;

/**
 * Arm bar: the controllers of a cell, what each does, and which of them the window shows. It is
 * there only where there are several.
 */
@SuppressWarnings("serial") // never written to a stream
public final class ArmBar extends JPanel {
  private final transient Actions actions;
  private final transient Consumer<String> choose;
  private final transient List<Choice> choices = new ArrayList<>();
  private final JPanel row = new JPanel(new MigLayout("insets 0, gap 2"));
  private transient List<String> names = List.of();

  /** The button of a controller. */
  private static final class Choice {
    private final SessionMember member;
    private final JToggleButton button;
    private final Dot dot = new Dot();

    Choice(SessionMember member, JToggleButton button) {
      this.member = member;
      this.button = button;
      button.setIcon(dot);
    }
  }

  /** A dot in the colour of what a controller does. */
  private static final class Dot implements Icon {
    private Supplier<Color> color = Palette::quiet;

    @Override
    public void paintIcon(Component c, Graphics g, int x, int y) {
      Graphics2D round = (Graphics2D) g.create();
      round.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      round.setColor(color.get());
      round.fillOval(x + 1, y + 1, getIconWidth() - 2, getIconHeight() - 2);
      round.dispose();
    }

    @Override
    public int getIconWidth() {
      return 10;
    }

    @Override
    public int getIconHeight() {
      return 10;
    }
  }

  /**
   * A bar that is not to be seen yet.
   *
   * @param choose told the name of the controller that is to be shown
   * @param together ids of the actions for all controllers
   */
  public ArmBar(Actions actions, Consumer<String> choose, List<String> together) {
    super(new MigLayout("insets 3 12 3 12, gap 8, hidemode 3", "[]6[grow, fill, 0::][]"));
    this.actions = actions;
    this.choose = choose;
    setName("arm-bar");
    setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Palette.line()));
    JLabel title = new JLabel(text("controller"));
    title.setForeground(Palette.quiet());
    add(title);
    add(row, "wmin 0");
    JPanel end = new JPanel(new MigLayout("insets 0, gap 4"));
    together.forEach(id -> end.add(button(id)));
    add(end);
    setVisible(false);
  }

  private JButton button(String id) {
    JButton button = new JButton(id.endsWith("run-all") ? text("runAll") : text("stopAll"));
    button.setName("arm-bar-" + id.replace('.', '-'));
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.setFocusable(true);
    button.addActionListener(event -> actions.run(id));
    button.getAccessibleContext().setAccessibleName(button.getText());
    actions.all().stream()
        .filter(each -> each.id().equals(id))
        .findFirst()
        .map(Action::title)
        .ifPresent(title -> button.setToolTipText(title + keys(id)));
    return button;
  }

  private String keys(String id) {
    String keys = actions.keysOf(id);
    return keys.isEmpty() ? "" : " (" + keys + ")";
  }

  /**
   * Shows what the controllers do.
   *
   * @param members empty for one that is alone
   * @param shown the one that the window shows
   */
  public void refresh(List<SessionMember> members, SessionMember shown) {
    List<String> now = members.stream().map(SessionMember::name).toList();
    if (!now.equals(names) || changed(members)) {
      names = now;
      fill(members);
    }
    setVisible(!members.isEmpty());
    for (Choice each : choices) {
      show(each, each.member.name().equals(shown.name()));
    }
  }

  private boolean changed(List<SessionMember> members) {
    for (int i = 0; i < choices.size(); i++) {
      if (choices.get(i).member != members.get(i)) {
        return true;
      }
    }
    return false;
  }

  private void fill(List<SessionMember> members) {
    row.removeAll();
    choices.clear();
    ButtonGroup group = new ButtonGroup();
    for (SessionMember each : members) {
      JToggleButton button = new JToggleButton(each.name());
      button.setName("arm-" + each.name());
      button.putClientProperty("JButton.buttonType", "toolBarButton");
      button.addActionListener(event -> choose.accept(each.name()));
      group.add(button);
      row.add(button);
      choices.add(new Choice(each, button));
    }
    row.revalidate();
    row.repaint();
  }

  private void show(Choice choice, boolean shown) {
    ControllerState state = choice.member.state();
    ProgramPhase phase = ProgramPhase.of(state);
    boolean stopped = !choice.member.armless() && state.safety().stop().isPresent();
    Supplier<Color> color =
        stopped
            ? Palette::error
            : switch (phase) {
              case RUNNING -> Palette::ok;
              case PAUSED -> Palette::warning;
              case STOPPED -> Palette::quiet;
            };
    choice.button.setSelected(shown);
    String keys = keys("controllers.show-" + (choices.indexOf(choice) + 1));
    String words =
        choice.member.armless()
            ? text("scriptOfTheCell", choice.member.name(), phase.word(), keys)
            : text(
                "armOfTheCell",
                choice.member.name(),
                choice.member.options().arm().displayName(),
                phase.word(),
                StateWords.of(state.safety().safetyMode()),
                keys);
    if (!words.equals(choice.button.getToolTipText())) {
      choice.button.setToolTipText(words);
      choice.button.getAccessibleContext().setAccessibleName(words);
      choice.dot.color = color;
      choice.button.repaint();
    }
  }
}
