package org.pendant.kit.form;

import java.awt.Component;
import java.awt.EventQueue;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import javax.swing.DefaultComboBoxModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.ShownFocus;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/**
 * Parts form: fields for the parts of a value. Each change makes another value, which is checked
 * while it is typed.
 *
 * @param <T> immutable
 */
public final class PartsForm<T> {
  /** How wide fields become at most. */
  private static final String FIELD = "growx, wmin 60, wmax 260";

  /** Between buttons, pixels before scaling. */
  public static final int BETWEEN = 6;

  private final String id;
  private final Function<T, String> refusal;
  private final Consumer<T> take;
  private final JPanel panel = new JPanel(new MigLayout("insets 0, gap 8 6, hidemode 3", LABELS));
  private final List<Follower<T>> followers = new ArrayList<>();
  private static final String LABELS = "[]12[60:240:260, fill]6[grow, left]";
  private Optional<T> value = Optional.empty();
  private boolean showing;

  /** Whether fields show the value whatever is typed in them. */
  private boolean afresh;

  /** What was shown before another thing; empty while the same thing is shown. */
  private Optional<T> other = Optional.empty();

  private String prefix = "";

  /** The sections that rows are being added to, the innermost one first. */
  private final Deque<Predicate<T>> within = new ArrayDeque<>();

  /** What is shown and hidden with a section. */
  private final Set<Component> inSections = Collections.newSetFromMap(new IdentityHashMap<>());

  private Runnable nothing = () -> {};
  private Measures measures = Measures.USUAL;
  private UnaryOperator<String> telling = why -> why;

  /** Shows its part of a value. */
  private interface Follower<T> {
    void show(T value);
  }

  /** Another value with what the user typed; refuses by an IllegalArgumentException. */
  public interface Change<T> {
    T with(T before, String text);
  }

  /**
   * An empty form.
   *
   * @param id with which the names of its fields begin
   * @param refusal why a value cannot be; empty if it can
   * @param take takes a value that can be
   */
  public PartsForm(String id, Function<T, String> refusal, Consumer<T> take) {
    this.id = id;
    this.refusal = refusal;
    this.take = take;
    panel.setOpaque(false);
  }

  public JComponent component() {
    return panel;
  }

  /** Shows numbers in other measures than the usual ones. */
  public PartsForm<T> in(Measures wanted) {
    measures = wanted;
    return this;
  }

  /** Tells why a text cannot be taken in the words that {@code words} makes of it. */
  public PartsForm<T> telling(UnaryOperator<String> words) {
    telling = words;
    return this;
  }

  /** What stands behind a number that is usually in {@code usual}. */
  public JLabel unit(Measure usual) {
    JLabel label = new JLabel(measures.of(usual).symbol());
    followers.add(now -> label.setText(measures.of(usual).symbol()));
    return label;
  }

  /** Runs whenever nothing is typed that could be taken. */
  public void whenNothing(Runnable listener) {
    nothing = listener;
  }

  /** Shows a value; what is being typed stays. */
  public void show(T next) {
    value = Optional.of(next);
    showing = true;
    followers.forEach(each -> each.show(next));
    showing = false;
  }

  /** Shows the same thing from another side: what was typed and cannot be taken is dropped. */
  public void showAfresh(T next) {
    afresh = true;
    show(next);
    afresh = false;
  }

  /**
   * Shows another thing. What was typed for the last one and cannot be taken is there again when
   * that one is.
   */
  public void showOther(T next) {
    other = value.or(() -> Optional.of(next));
    show(next);
    other = Optional.empty();
  }

  /** Has the names of rows begin so from now on, after the form's id. */
  public PartsForm<T> naming(String before) {
    prefix = before;
    return this;
  }

  private String why(Change<T> change, String text) {
    if (value.isEmpty()) {
      return "";
    }
    try {
      return told(refusal.apply(change.with(value.get(), text)));
    } catch (IllegalArgumentException e) {
      return told(e.getMessage());
    }
  }

  private String told(String why) {
    return Messages.shown(telling.apply(why));
  }

  private void take(Change<T> change, String text) {
    value.ifPresent(before -> take.accept(change.with(before, text)));
  }

  /** A field that another component places. */
  public EntryField entry(String name, String tip, Function<T, String> text, Change<T> change) {
    EntryField field =
        TitledCard.named(
                ShownFocus.of(
                    new EntryField(8, typed -> why(change, typed), typed -> take(change, typed))),
                id + "-" + name,
                tip)
            .withTip(tip);
    field.whenNothing(() -> nothing.run());
    Map<T, String> left = new HashMap<>();
    followers.add(
        now -> {
          if (afresh) {
            field.show(text.apply(now));
            return;
          }
          if (other.isEmpty()) {
            field.follow(text.apply(now));
            return;
          }
          if (!field.refusal().isEmpty()) {
            left.put(other.get(), field.getText());
          }
          field.show(text.apply(now));
          Optional.ofNullable(left.remove(now)).ifPresent(field::setText);
        });
    return field;
  }

  /**
   * As {@link #entry}, for a number.
   *
   * @param unit in which it usually is
   */
  public EntryField number(
      String name,
      String tip,
      Measure unit,
      ToDoubleFunction<T> get,
      BiFunction<T, Double, T> with) {
    EntryField field =
        entry(
            name,
            tip,
            now -> measures.of(unit).text(get.applyAsDouble(now)),
            (before, text) -> with.apply(before, measures.of(unit).parse(text)));
    field.setHorizontalAlignment(JLabel.TRAILING);
    return field;
  }

  private String nameOf(String name) {
    return prefix + name.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
  }

  /**
   * A row for a text.
   *
   * @param name of the field, which is the same in every language; words become one with dashes
   */
  public PartsForm<T> text(
      String name, String label, Function<T, String> get, BiFunction<T, String, T> with) {
    return text(name, label, label, "", get, with);
  }

  /**
   * A row for a text.
   *
   * @param tip what it is for
   * @param empty what is seen in the field while nothing is in it
   */
  public PartsForm<T> text(
      String name,
      String label,
      String tip,
      String empty,
      Function<T, String> get,
      BiFunction<T, String, T> with) {
    EntryField field = entry(nameOf(name), tip, get, with::apply);
    field.putClientProperty("JTextField.placeholderText", empty);
    row(label, field, new JLabel());
    return this;
  }

  /** A row for a number. */
  public PartsForm<T> numberRow(
      String name,
      String label,
      Measure unit,
      ToDoubleFunction<T> get,
      BiFunction<T, Double, T> with) {
    row(label, number(nameOf(name), label, unit, get, with), unit(unit));
    return this;
  }

  /**
   * A row for a number that may be left out.
   *
   * @param hint about it; asked again whenever it is shown
   * @param standing what holds where it is left out, to be seen in the empty field
   * @param without what is to be seen there where nothing holds
   */
  public PartsForm<T> optionalNumber(
      String name,
      String label,
      Supplier<String> hint,
      Measure unit,
      OptionalDouble standing,
      String without,
      Function<T, OptionalDouble> get,
      BiFunction<T, OptionalDouble, T> with) {
    EntryField field =
        entry(
            nameOf(name),
            label,
            now -> {
              OptionalDouble number = get.apply(now);
              return number.isPresent() ? measures.of(unit).text(number.getAsDouble()) : "";
            },
            (before, text) ->
                with.apply(
                    before,
                    text.isBlank()
                        ? OptionalDouble.empty()
                        : OptionalDouble.of(measures.of(unit).parse(text))));
    field.setHorizontalAlignment(JLabel.TRAILING);
    followers.add(
        now -> {
          field.withTip(hint.get());
          field.putClientProperty(
              "JTextField.placeholderText",
              standing.isPresent() ? measures.of(unit).text(standing.getAsDouble()) : without);
        });
    row(label, field, unit(unit));
    return this;
  }

  private void row(String label, EntryField field, JLabel unit) {
    Remark problem = new Remark(field.getName() + "-problem", Palette::error);
    field.whenRefused(() -> problem.say(field.refusal()));
    JLabel words = new JLabel(label);
    words.setLabelFor(field);
    panel.add(words);
    panel.add(field, FIELD);
    panel.add(unit, "wrap");
    panel.add(problem, "skip 1, span 2, wrap, " + Remark.LAYOUT);
  }

  /** A row for one of several. */
  public <C> PartsForm<T> choice(
      String name,
      String label,
      Function<T, List<C>> choices,
      Function<C, String> words,
      Function<T, C> get,
      BiFunction<T, C, T> with) {
    return choice(name, label, label, choices, words, get, with);
  }

  /**
   * A row for one of several.
   *
   * @param tip what it is for
   */
  public <C> PartsForm<T> choice(
      String name,
      String label,
      String tip,
      Function<T, List<C>> choices,
      Function<C, String> words,
      Function<T, C> get,
      BiFunction<T, C, T> with) {
    JComboBox<C> box =
        TitledCard.named(ShownFocus.of(new Choice<>(words)), id + "-" + nameOf(name), tip);
    box.setRenderer(new Words<>(words));
    Remark problem = new Remark(box.getName() + "-problem", Palette::error);
    List<C> shown = new ArrayList<>();
    followers.add(
        now -> {
          List<C> all = new ArrayList<>(choices.apply(now));
          if (!all.contains(get.apply(now))) {
            // files may say what is not offered
            all.addFirst(get.apply(now));
          }
          if (!all.equals(shown)) {
            shown.clear();
            shown.addAll(all);
            DefaultComboBoxModel<C> model = new DefaultComboBoxModel<>();
            all.forEach(model::addElement);
            box.setModel(model);
          }
          box.setSelectedItem(get.apply(now));
          problem.say("");
        });
    box.addActionListener(
        event -> {
          int index = box.getSelectedIndex();
          if (!showing && index >= 0) {
            C wanted = box.getItemAt(index);
            choose(problem, before -> with.apply(before, wanted));
          }
        });
    JLabel title = new JLabel(label);
    title.setLabelFor(box);
    panel.add(title);
    panel.add(box, FIELD + ", wrap");
    panel.add(problem, "skip 1, span 2, wrap, " + Remark.LAYOUT);
    return this;
  }

  private void choose(Remark problem, Function<T, T> change) {
    if (value.isEmpty()) {
      return;
    }
    try {
      T next = change.apply(value.get());
      String why = told(refusal.apply(next));
      problem.say(why);
      if (why.isEmpty()) {
        take.accept(next);
      } else {
        show(value.get());
        problem.say(why);
      }
    } catch (IllegalArgumentException e) {
      show(value.get());
      problem.say(told(e.getMessage()));
    }
  }

  /** A row for yes or no. */
  public PartsForm<T> check(
      String name, String label, Function<T, Boolean> get, BiFunction<T, Boolean, T> with) {
    return check(name, label, label, get, with);
  }

  /**
   * A row for yes or no.
   *
   * @param tip what it is for
   */
  public PartsForm<T> check(
      String name,
      String label,
      String tip,
      Function<T, Boolean> get,
      BiFunction<T, Boolean, T> with) {
    JCheckBox box =
        TitledCard.named(ShownFocus.of(new JCheckBox(label)), id + "-" + nameOf(name), tip);
    box.setOpaque(false);
    Remark problem = new Remark(box.getName() + "-problem", Palette::error);
    followers.add(
        now -> {
          box.setSelected(get.apply(now));
          problem.say("");
        });
    box.addActionListener(event -> choose(problem, before -> with.apply(before, box.isSelected())));
    panel.add(box, "skip 1, span 2, wrap");
    panel.add(problem, "skip 1, span 2, wrap, " + Remark.LAYOUT);
    return this;
  }

  /** A row with something that follows the value by itself. */
  public PartsForm<T> add(String label, JComponent component) {
    JLabel words = new JLabel(label);
    words.setLabelFor(component);
    panel.add(words);
    panel.add(component, "span 2, growx, wmin 0, wmax 260, wrap");
    return this;
  }

  /** A row of buttons. */
  public PartsForm<T> buttons(JButton... buttons) {
    JPanel row = new JPanel(new WrappingRow(BETWEEN));
    row.setOpaque(false);
    for (JButton each : buttons) {
      row.add(each);
    }
    panel.add(row, "skip 1, span 2, growx, wmin 0, pad 0 -" + BETWEEN + " 0 0, wrap");
    return this;
  }

  /** A heading above what comes next, wrapped where it is long. */
  public PartsForm<T> heading(String text) {
    return heading(() -> text);
  }

  /** A heading that may change with what is around the value. */
  public PartsForm<T> heading(Supplier<String> text) {
    Remark heading = new Remark(id + "-heading", null);
    heading.putClientProperty("FlatLaf.styleClass", "semibold");
    heading.say(text.get());
    followers.add(now -> heading.say(text.get()));
    panel.add(heading, "span, gaptop 8, wrap, " + Remark.LAYOUT);
    return this;
  }

  /** A quiet sentence. */
  public PartsForm<T> note(String text) {
    return note(() -> text);
  }

  /** A quiet sentence that may change with what is around the value. */
  public PartsForm<T> note(Supplier<String> text) {
    Remark remark = new Remark(id + "-note", Palette::quiet);
    remark.say(text.get());
    // again, as it may have been hidden with its section
    followers.add(now -> remark.say(text.get()));
    panel.add(remark, "span, wrap, " + Remark.LAYOUT);
    return this;
  }

  /** A sentence that depends on the value; empty for none. */
  public PartsForm<T> remark(Function<T, String> words) {
    Remark remark = new Remark(id + "-remark", Palette::warning);
    followers.add(now -> remark.say(words.apply(now)));
    panel.add(remark, "span, wrap, " + Remark.LAYOUT);
    return this;
  }

  /**
   * Rows that are there for some values only.
   *
   * @param when for which
   * @param rows adds them
   */
  public PartsForm<T> section(Predicate<T> when, Runnable rows) {
    int from = panel.getComponentCount();
    Predicate<T> all = within.stream().reduce(when, Predicate::and);
    within.push(when);
    rows.run();
    within.pop();
    List<Component> own =
        Arrays.stream(panel.getComponents()).skip(from).filter(inSections::add).toList();
    followers.add(
        now -> {
          boolean on = all.test(now);
          for (Component each : own) {
            // remarks are there when they have something to say
            each.setVisible(on && (!(each instanceof Remark) || each.isVisible()));
          }
        });
    return this;
  }

  /** Something over the whole width. */
  public PartsForm<T> wide(JComponent component) {
    panel.add(component, "span, growx, wrap");
    return this;
  }

  /** A grid of fields with one place for what is wrong with any of them. */
  public PartsForm<T> grid(JPanel grid, List<EntryField> fields) {
    Remark problem = new Remark(id + "-grid-problem", Palette::error);
    Runnable tell =
        () -> {
          String before = problem.getText();
          problem.say(
              fields.stream()
                  .filter(each -> !each.refusal().isEmpty())
                  .map(
                      each ->
                          Messages.told(
                              each.getAccessibleContext().getAccessibleName(), each.refusal()))
                  .findFirst()
                  .orElse(""));
          if (!problem.getText().equals(before)) {
            // behind the layout that the sentence has asked for; it may be below a large grid
            EventQueue.invokeLater(() -> panel.scrollRectToVisible(problem.getBounds()));
          }
        };
    fields.forEach(each -> each.whenRefused(tell));
    wide(grid);
    panel.add(problem, "span, wrap, " + Remark.LAYOUT);
    return this;
  }

  /** Runs with each value that is shown. */
  public PartsForm<T> follow(Consumer<T> follower) {
    followers.add(follower::accept);
    return this;
  }

  /** Tells what is chosen, which a narrow form may have no room for, and what it is for. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Choice<C> extends JComboBox<C> {
    private final transient Function<C, String> words;

    Choice(Function<C, String> words) {
      this.words = words;
    }

    @Override
    public String getToolTipText() {
      int index = getSelectedIndex();
      String tip = super.getToolTipText();
      return index < 0 ? tip : words.apply(getItemAt(index)) + " \u2013 " + tip;
    }
  }

  /** What a choice is called. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Words<C> extends DefaultListCellRenderer {
    private final transient Function<C, String> words;

    Words(Function<C, String> words) {
      this.words = words;
    }

    @Override
    @SuppressWarnings("unchecked") // the list holds nothing else
    public Component getListCellRendererComponent(
        JList<?> list, Object item, int index, boolean selected, boolean focused) {
      String text = item == null ? "" : words.apply((C) item);
      return super.getListCellRendererComponent(list, text, index, selected, focused);
    }
  }
}
