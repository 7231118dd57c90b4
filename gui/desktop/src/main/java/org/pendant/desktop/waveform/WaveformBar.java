package org.pendant.desktop.waveform;

import static org.pendant.desktop.waveform.WaveformTexts.text;

import java.awt.Component;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.InputChange;
import org.pendant.controller.io.SignalBank;
import org.pendant.kit.form.Measure;
import org.pendant.kit.layout.Squeeze;
import org.pendant.kit.text.Messages;

/** Waveform bar: the fields and buttons above the rows. */
@SuppressWarnings("serial") // never written to a stream
final class WaveformBar extends JPanel {
  private final transient WaveformDraft draft;
  private final transient WaveformCanvas canvas;
  private final JCheckBox play = new JCheckBox(text("play"));
  private final JComboBox<String> signal = new JComboBox<>(signals());
  private final JTextField value = new JTextField(6);
  private final JPanel valueGroup = together();
  private final JTextField period = new JTextField(4);
  private final JLabel repeat = new JLabel(text("repeatAfter"));
  private transient Optional<Squeeze> squeeze = Optional.empty();
  private final transient Consumer<String> complain;

  /**
   * A bar for a draft.
   *
   * @param complain takes what is wrong with what was typed; empty when nothing is
   */
  WaveformBar(WaveformDraft draft, WaveformCanvas canvas, Consumer<String> complain) {
    super(new MigLayout("insets 4 6 4 6, gap 6, hidemode 3", "", "[center]"));
    this.draft = draft;
    this.canvas = canvas;
    this.complain = complain;
    name(play, "play", text("whileAProgramRunsTheInputs"));
    add(play);
    name(signal, "signal", text("anInputTypeTheNameOf"));
    signal.setEditable(true);
    nameEditor();
    // Other colours bring another one.
    signal.addPropertyChangeListener("editor", event -> nameEditor());
    add(signal);
    add(button("add", text("add"), text("aRowForThisInputLow"), this::addRow));
    addPeriod();
    draft.addListener(this::refresh);
    refresh();
  }

  private void nameEditor() {
    if (signal.getEditor() == null) {
      return;
    }
    Component text = signal.getEditor().getEditorComponent();
    text.setName("waveform-signal-text");
    text.getAccessibleContext().setAccessibleName(text("input"));
  }

  private void addPeriod() {
    name(period, "period", text("secondsAfterWhichEverythingHappens"));
    period.addActionListener(event -> changePeriod());
    period.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            changePeriod();
          }
        });
    add(together(repeat, period, new JLabel("s")));
  }

  /** Adds what comes last: it is there only while a row with numbers is selected. */
  void addValue() {
    name(value, "value", text("whatAnInputWithNumbersGets"));
    value.addActionListener(event -> changeValue());
    valueGroup.add(new JLabel(text("value")));
    valueGroup.add(value);
    add(valueGroup);
    refresh();
  }

  /**
   * Keeps to one row: where there is little room, what the menu has, too, is left out.
   *
   * @param spared the least important first
   */
  void keepToOneRow(List<JButton> spared) {
    List<Squeeze.Part> parts = new ArrayList<>();
    parts.add(whole -> repeat.setText(whole ? text("repeatAfter") : text("every")));
    spared.forEach(each -> parts.add(each::setVisible));
    squeeze = Optional.of(new Squeeze(this, parts));
    squeeze.get().fitLater();
  }

  private static JPanel together(JComponent... parts) {
    JPanel group = new JPanel(new MigLayout("insets 0, gap 4"));
    for (JComponent each : parts) {
      // A field without room for its number would look like a line.
      group.add(each, each instanceof JTextField ? "wmin pref" : "");
    }
    return group;
  }

  private static String[] signals() {
    List<String> names = new ArrayList<>();
    for (SignalBank bank : SignalBank.values()) {
      for (int i = 0; bank.input() && i < bank.size(); i++) {
        names.add(bank.text() + "[" + i + "]");
      }
    }
    for (AnalogBank bank : AnalogBank.values()) {
      for (int i = 0; bank.input() && i < AnalogBank.SIZE; i++) {
        names.add(bank.name(i));
      }
    }
    return names.toArray(String[]::new);
  }

  private static void name(JComponent component, String name, String tip) {
    component.setName("waveform-" + name);
    component.setToolTipText(tip);
    component.getAccessibleContext().setAccessibleName(tip);
  }

  /** A button of the bar. */
  static JButton button(String name, String text, String tip, Runnable run) {
    JButton button = new JButton(text);
    button.setName("waveform-" + name);
    button.setToolTipText(tip);
    button.putClientProperty("FlatLaf.style", "margin: 2,8,2,8; minimumWidth: 0");
    button.getAccessibleContext().setAccessibleName(text);
    button.addActionListener(event -> run.run());
    return button;
  }

  /** Whether programs run with what is drawn. */
  boolean playing() {
    return play.isSelected();
  }

  /** Has programs run with what is drawn, or not. */
  void setPlaying(boolean on) {
    play.setSelected(on);
  }

  /** Tells {@code listener} when that changes. */
  void onPlaying(Runnable listener) {
    play.addActionListener(event -> listener.run());
  }

  /** What an input with numbers gets where people draw. */
  String number() {
    String typed = value.getText().strip();
    return typed.isEmpty()
        ? canvas.row().flatMap(row -> row.at(canvas.cursorS())).orElse("0")
        : typed;
  }

  private void addRow() {
    String name = String.valueOf(signal.getEditor().getItem()).strip();
    int there = draft.sheet().indexOf(name);
    if (there >= 0) {
      canvas.select(there);
      canvas.requestFocusInWindow();
      return;
    }
    tryTo(
        signal,
        () -> {
          draft.set(draft.sheet().plus(WaveRow.idle(name)));
          canvas.select(draft.sheet().rows().size() - 1);
          canvas.requestFocusInWindow();
        });
  }

  private void changeValue() {
    Optional<WaveRow> row = canvas.row().filter(each -> !each.level());
    row.ifPresent(
        each ->
            tryTo(
                value,
                () -> {
                  int change = each.changeNear(canvas.cursorS(), canvas.nearS());
                  double fromS =
                      change >= 0 ? each.changes().get(change).timeS() : canvas.cursorS();
                  canvas.replace(each.with(fromS, value.getText().strip()));
                }));
  }

  private void changePeriod() {
    String text = period.getText().strip().replace(',', '.');
    tryTo(
        period,
        () ->
            draft.set(
                draft
                    .sheet()
                    .repeating(
                        text.isEmpty()
                            ? OptionalDouble.empty()
                            : OptionalDouble.of(number(text)))));
  }

  private static double number(String text) {
    try {
      double periodS = Double.parseDouble(text);
      if (periodS >= WaveformPainter.FRAME_S && periodS <= InputChange.MAX_TIME_S) {
        return periodS;
      }
    } catch (NumberFormatException e) {
      // the message below says what is wrong with it
    }
    throw new IllegalArgumentException(text("repeatAfterMustBeSecondsFrom", text));
  }

  private void tryTo(JComponent field, Runnable change) {
    try {
      change.run();
      field.putClientProperty("JComponent.outline", null);
      complain.accept("");
    } catch (IllegalArgumentException e) {
      field.putClientProperty("JComponent.outline", "error");
      complain.accept(Messages.shown(e.getMessage()));
    }
  }

  /** Shows what the draft and the selected row have. */
  void refresh() {
    if (!period.isFocusOwner()) {
      OptionalDouble periodS = draft.sheet().periodS();
      period.setText(periodS.isPresent() ? Measure.SECOND.text(periodS.getAsDouble()) : "");
    }
    Optional<WaveRow> row = canvas.row();
    boolean number = row.isPresent() && !row.get().level();
    if (number != valueGroup.isVisible()) {
      valueGroup.setVisible(number);
      squeeze.ifPresent(Squeeze::fitLater);
    }
    if (!value.isFocusOwner()) {
      value.setText(
          row.filter(each -> !each.level()).flatMap(each -> each.at(canvas.cursorS())).orElse(""));
    }
  }
}
