package org.pendant.desktop.shell.run;

import static org.pendant.desktop.shell.run.RunTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.command.Command;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.debug.Favourites;
import org.pendant.desktop.debug.HiddenNames;
import org.pendant.desktop.debug.VariablesView;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.ActionButton;
import org.pendant.kit.action.ActionButtons;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.layout.FlushRow;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.WideContent;
import org.pendant.kit.theme.Card;
import org.pendant.kit.theme.Palette;
import org.pendant.script.variables.VariableSamples;

/**
 * Run view: the screen to watch a program on: what it does, where the arm is, what is the matter.
 */
public final class RunView implements View {
  private static final String WIDE = "insets 16, gap 16, hidemode 3, wrap 2";
  private static final String WIDE_COLUMNS = "[grow, fill, 0::][fill, pref:pref:]";
  private static final String NARROW = "insets 16, gap 16, hidemode 3, wrap 1";

  /** Six readings that nobody has taken. */
  private static final List<String> NOT_KNOWN = Collections.nCopies(6, " ");

  /** Below this width (pixels before scaling) the cards are below one another. */
  private static final int NARROW_WIDTH = 660;

  private final Workbench workbench;
  private final RunProgram run;
  private final MigLayout layout = new MigLayout(WIDE, WIDE_COLUMNS, "[][][][][grow]");
  private final JPanel content = new WideContent(layout);
  private final JScrollPane scroll = new SettledScroll(content);
  private final JLabel name = new JLabel(" ");
  private final JLabel state = new JLabel(" ");
  private final JLabel elapsed = new JLabel(" ");
  private final JLabel paused = new JLabel();
  private final JLabel turns = new JLabel();
  private final JButton node = new JButton();
  private final JLabel line = new JLabel(" ");
  private final JLabel waiting = new JLabel();
  private final StopPanel stop;
  private final VariablesPanel variables;
  private final MessagesPanel messages = new MessagesPanel();
  private final NumbersPanel tcp =
      new NumbersPanel("run-tcp", text("tcpInTheBase"), RunFacts.POSE, RunFacts.POSE);
  private final NumbersPanel joints =
      new NumbersPanel("run-joints", text("joints"), RunFacts.JOINT_WORDS, RunFacts.JOINTS);
  private Optional<RunNode> shownNode = Optional.empty();
  private final List<ActionButton> buttons;
  private final ActionButtons buttonRow;
  private boolean narrow;

  /**
   * The Run screen.
   *
   * @param run the program that runs, or ran last
   * @param send has the controller do something, and tells when it is refused
   * @param favourites variables that come first
   * @param hidden variables that are left out
   * @param showBefore shows how it came to what happened at a time, s
   */
  public RunView(
      Workbench workbench,
      ActionTable actions,
      RunProgram run,
      Consumer<Command> send,
      Favourites favourites,
      HiddenNames hidden,
      DoubleConsumer showBefore) {
    this.workbench = workbench;
    this.run = run;
    variables = new VariablesPanel(favourites, hidden, () -> workbench.show(VariablesView.ID));
    stop = new StopPanel(send, run, () -> workbench.session().options().scene(), showBefore);
    buttons =
        List.of(
            button(actions, "program.run", text("run"), Glyph.PLAY.icon(28, Palette.ok())),
            button(actions, "program.pause", text("pause"), Glyph.PAUSE.icon(28)),
            button(actions, "program.stop", text("stop"), Glyph.STOP.icon(28, Palette.error())));
    buttons
        .getFirst()
        .reserve(Arrays.stream(ProgramPhase.values()).map(ProgramPhase::runWord).toList());
    buttonRow = new ActionButtons(buttons);
    // The first picture is there before the robot is.
    tcp.show(FormMemory.read(workbench.settings()).labels(), NOT_KNOWN);
    joints.show(NOT_KNOWN);
    scroll.setName("run-view");
    scroll.getAccessibleContext().setAccessibleName(title());
    content.add(stop.component(), "spanx, growx, wmin 0");
    content.add(program());
    content.add(tcp.component(), "growy");
    content.add(variables.component(), "growy");
    content.add(joints.component(), "growy");
    content.add(messages.component(), "spanx, growx, wmin 0");
  }

  /** Puts the cards beside or below one another. */
  private void arrange() {
    boolean now = UIScale.unscale(scroll.getViewport().getWidth()) < NARROW_WIDTH;
    if (now != narrow) {
      narrow = now;
      layout.setLayoutConstraints(narrow ? NARROW : WIDE);
      layout.setColumnConstraints(narrow ? "[grow, fill, 0::]" : WIDE_COLUMNS);
      content.revalidate();
    }
  }

  private static ActionButton button(ActionTable actions, String id, String text, Icon icon) {
    ActionButton button = new ActionButton(actions, id, text, icon);
    button.setName("run-view-" + id.substring(id.indexOf('.') + 1));
    button.putClientProperty("FlatLaf.styleClass", "large");
    return button;
  }

  private JPanel program() {
    JPanel card =
        new Card(new MigLayout("insets 16, gap 8, wrap 1, hidemode 3", "[grow, fill, 0::]", ""));
    card.setName("run-program");
    name.putClientProperty("FlatLaf.styleClass", "h1");
    state.putClientProperty("FlatLaf.styleClass", "h3");
    elapsed.putClientProperty("FlatLaf.styleClass", "h2");
    elapsed.setToolTipText(text("robotTimeThatTheProgramHas"));
    line.putClientProperty("FlatLaf.styleClass", "monospaced");
    name("run-name", name, text("program"));
    name("run-state", state, text("programState"));
    name("run-elapsed", elapsed, text("runningTime"));
    paused.putClientProperty("FlatLaf.styleClass", "h2");
    paused.setToolTipText(text("robotTimeInThePausesOf"));
    name("run-paused", paused, text("pausedTime"));
    turns.putClientProperty("FlatLaf.styleClass", "h2");
    turns.setToolTipText(text("howManyTimesTheMainProgram"));
    name("run-turns", turns, text("turnsOfTheMainProgram"));
    node.setName("run-node");
    node.putClientProperty("FlatLaf.styleClass", "h3");
    node.putClientProperty("FlatLaf.style", "toolbar.margin: 2,0,2,4");
    node.putClientProperty("JButton.buttonType", "toolBarButton");
    node.setVisible(false);
    node.setHorizontalAlignment(SwingConstants.LEADING);
    node.addActionListener(event -> shownNode.ifPresent(run::show));
    name("run-line", line, text("lineOfTheProgram"));
    name("run-waiting", waiting, text("popups"));
    waiting.setIcon(Glyph.WARNING.icon(16, Palette.warning()));
    waiting.setVisible(false);
    card.add(name, "wmin 0");
    card.add(state, "wmin 0");
    JPanel times = new FlushRow(24);
    times.add(elapsed);
    times.add(paused);
    times.add(turns);
    card.add(times, "wmin 0");
    card.add(node, "wmin 0");
    card.add(line, "wmin 0");
    card.add(waiting, "wmin 0");
    JPanel row = new JPanel(new MigLayout("insets 8 0 0 0, gap 8", "[sg b][sg b][sg b]"));
    row.setOpaque(false);
    buttons.forEach(each -> row.add(each, "h 56::, sg b, grow 0"));
    card.add(row);
    return card;
  }

  private static void name(String name, JLabel label, String meaning) {
    label.setName(name);
    label.getAccessibleContext().setAccessibleDescription(meaning);
  }

  @Override
  public String id() {
    return "run";
  }

  @Override
  public String title() {
    return text("run");
  }

  @Override
  public JComponent component() {
    return scroll;
  }

  @Override
  public void refresh(ControllerState snapshot) {
    arrange();
    PoseForm form = FormMemory.read(workbench.settings());
    RunFacts facts = RunFacts.of(snapshot, run, form);
    boolean left = run.left(snapshot);
    show(name, facts.title());
    name.setToolTipText(facts.title());
    show(state, facts.state());
    state.setToolTipText(facts.state());
    state.setForeground(facts.failed() ? Palette.error() : name.getForeground());
    show(elapsed, facts.elapsed().isEmpty() ? " " : facts.elapsed());
    show(paused, facts.paused());
    paused.setForeground(Palette.quiet());
    show(turns, left ? "" : turnText(run.turns(snapshot)));
    showNode(run.node(snapshot));
    show(line, facts.line().isEmpty() ? " " : facts.line());
    line.setToolTipText(facts.line().isEmpty() ? null : facts.line());
    line.setForeground(facts.failed() ? Palette.error() : name.getForeground());
    show(waiting, facts.waiting());
    waiting.setVisible(!facts.waiting().isEmpty());
    waiting.setForeground(Palette.warning());
    stop.refresh(snapshot, form);
    tcp.show(form.labels(), facts.tcp());
    joints.show(facts.joints());
    variables.refresh(
        snapshot.program().name(),
        left ? VariableSamples.NONE : snapshot.variables(),
        run.installationVariables());
    messages.refresh(snapshot, workbench.session().robot(), run.recordedLog());
    buttons.getFirst().setText(ProgramPhase.of(workbench.session().state()).runWord());
    buttonRow.refresh();
  }

  private static String turnText(OptionalLong turns) {
    return turns.isPresent() && turns.getAsLong() > 0 ? text("turn", turns.getAsLong()) : "";
  }

  private void showNode(Optional<RunNode> now) {
    if (!now.equals(shownNode)) {
      // Room for one once there was one: what is below must not jump.
      node.setVisible(node.isVisible() || now.isPresent());
      shownNode = now;
      String words = now.map(each -> each.number() + "  " + each.label()).orElse(" ");
      node.setText(words);
      node.setEnabled(now.isPresent());
      node.setToolTipText(now.isPresent() ? text("showsTheNodeInTheProgram", words) : null);
      node.getAccessibleContext().setAccessibleName(text("node", words));
    }
  }

  private static void show(JLabel label, String text) {
    if (!text.equals(label.getText())) {
      label.setText(text);
    }
  }
}
