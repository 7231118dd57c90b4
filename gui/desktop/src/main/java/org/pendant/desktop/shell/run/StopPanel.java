package org.pendant.desktop.shell.run;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.command.Command;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Scene;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.scene.TouchedAtStop;
import org.pendant.desktop.session.ArmReadiness;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.action.RoomyButton;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.theme.Card;
import org.pendant.kit.theme.Palette;

/** Stop panel: why the arm is stopped and what to do about it; hidden while it is not. */
final class StopPanel {
  private final JPanel panel =
      new Card(new MigLayout("insets 16, gap 8, wrap 1, hidemode 3", "[grow, fill, 0::]", ""));
  private final JLabel title =
      new JLabel("", Glyph.ERROR.icon(20, Palette.error()), JLabel.LEADING);
  private final JTextArea message = text("stop-message", RunTexts.text("whatHappened"));
  private final JPanel facts =
      new JPanel(new MigLayout("insets 0, gap 16 4, wrap 2", "[][grow, 0::]", ""));
  private final JTextArea suggestion = text("stop-suggestion", RunTexts.text("whatToDo"));
  private final RoomyButton remedy = new RoomyButton("", null);
  private final JButton source = new JButton();
  private final JButton recording = new JButton(RunTexts.text("showRecording"));
  private Optional<StopCard> shown = Optional.empty();
  private Optional<Command> command = Optional.empty();
  private OptionalDouble stopS = OptionalDouble.empty();
  private final RunProgram run;
  private final Supplier<Scene> scene;
  private final TouchedAtStop touched = new TouchedAtStop();

  StopPanel(
      Consumer<Command> send, RunProgram run, Supplier<Scene> scene, DoubleConsumer showBefore) {
    this.run = run;
    this.scene = scene;
    panel.setName("stop-card");
    panel.setVisible(false);
    title.putClientProperty("FlatLaf.styleClass", "h3");
    facts.setOpaque(false);
    remedy.setName("stop-remedy");
    remedy.addActionListener(event -> command.ifPresent(send));
    source.setName("stop-source");
    source.setToolTipText(RunTexts.text("showsWhereTheProgramWas"));
    source.addActionListener(event -> shown.ifPresent(this::showSource));
    recording.setName("stop-recording");
    recording.setToolTipText(RunTexts.text("showsTheTwoSecondsBeforeThe"));
    recording.getAccessibleContext().setAccessibleName(recording.getText());
    recording.addActionListener(event -> stopS.ifPresent(showBefore));
    panel.add(title);
    panel.add(message);
    panel.add(facts);
    panel.add(suggestion);
    JPanel buttons = new JPanel(new MigLayout("insets 0, gap 8, hidemode 3", "[][][]"));
    buttons.setOpaque(false);
    buttons.add(remedy);
    buttons.add(source);
    buttons.add(recording);
    panel.add(buttons);
  }

  private static JTextArea text(String name, String meaning) {
    JTextArea area = new JTextArea();
    area.setName(name);
    area.setEditable(false);
    area.setLineWrap(true);
    area.setWrapStyleWord(true);
    area.setOpaque(false);
    area.setBorder(BorderFactory.createEmptyBorder());
    area.setToolTipText(meaning);
    area.getAccessibleContext().setAccessibleName(meaning);
    return area;
  }

  JPanel component() {
    return panel;
  }

  void refresh(ControllerState state, PoseForm form) {
    Optional<StopCard> card = StopCard.of(state, touched.of(state, scene.get()), form);
    stopS =
        state
            .safety()
            .stop()
            .map(stop -> OptionalDouble.of(stop.timeS()))
            .orElse(OptionalDouble.empty());
    if (!card.equals(shown)) {
      shown = card;
      // It counts seconds at first.
      remedy.reserve(List.of(ArmReadiness.of(state).remedy()));
      card.ifPresent(this::show);
      panel.setVisible(card.isPresent());
    }
    if (card.isPresent()) {
      showRemedy(ArmReadiness.of(state));
    }
  }

  private void show(StopCard card) {
    title.setText(card.title());
    title.setForeground(Palette.error());
    message.setText(card.message());
    facts.removeAll();
    for (StopCard.Fact fact : card.facts()) {
      JLabel name = new JLabel(fact.name());
      name.setForeground(Palette.quiet());
      facts.add(name);
      facts.add(new JLabel(fact.value()));
    }
    suggestion.setText(card.suggestion());
    source.setVisible(card.line() > 0);
    source.setText(RunTexts.text("show", place(card.line())));
    source.getAccessibleContext().setAccessibleName(source.getText());
    panel.revalidate();
  }

  /** The node of a tree, the line of a script. */
  private String place(int line) {
    return run.nodeAt(line)
        .map(RunNode::words)
        .orElseGet(() -> RunTexts.text("inLine", run.shownLine(line)));
  }

  private void showSource(StopCard card) {
    run.nodeAt(card.line()).ifPresentOrElse(run::show, () -> run.showLine(card.line()));
  }

  private void showRemedy(ArmReadiness readiness) {
    command = readiness.command();
    remedy.setVisible(!readiness.remedy().isEmpty());
    remedy.setText(readiness.remedy());
    remedy.setEnabled(command.isPresent());
    remedy.setToolTipText(readiness.hint());
    remedy.getAccessibleContext().setAccessibleName(readiness.remedy());
  }
}
