package org.pendant.kit.form;

import static org.pendant.kit.form.FormFieldTexts.text;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.InnerScroll;
import org.pendant.kit.layout.ShownFocus;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/**
 * Item list: several things of one kind: a list of them, buttons, and a form for the chosen one.
 *
 * @param <T> immutable
 */
public final class Items<T> {
  private static final int ROWS = 6;

  private final String id;
  private final Model<T> model;
  private final Function<T, String> words;
  private final DefaultListModel<T> shown = new DefaultListModel<>();
  private final JList<T> list = new Rows();
  private final JPanel buttons = new JPanel(new WrappingRow(PartsForm.BETWEEN));
  private final List<JButton> adders = new ArrayList<>();
  private final JButton remove = new JButton(text("remove"));
  private final JButton up = new JButton(text("up"));
  private final JButton down = new JButton(text("down"));
  private final Remark problem;
  private final Remark empty;
  private final PartsForm<T> form;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, gap 8 6, wrap, hidemode 3", "[grow, fill]"));
  private int chosen = -1;

  /** The place of the one that the form shows; -1 for none. */
  private int inForm = -1;

  private boolean showing;

  /**
   * A kind of things that can be added.
   *
   * @param word with which the name of its entry ends
   * @param fresh makes one
   */
  public record Kind<T>(String word, String title, Supplier<T> fresh) {}

  /** Where the things are kept. */
  public interface Model<T> {

    /** All of them. */
    List<T> list();

    /** Why there cannot be these in their place; empty if there can. */
    String refusal(List<T> next);

    /**
     * Puts others in their place.
     *
     * @param before the one that was changed or removed
     * @param after what it was changed into, or the new one
     */
    void take(List<T> next, Optional<T> before, Optional<T> after);

    /** Whether they can be changed now. */
    default boolean editable() {
      return true;
    }
  }

  /**
   * Nothing shown yet.
   *
   * @param id with which the names of components begin
   * @param what the list is called
   * @param words what one is called in it
   * @param whenEmpty what will be here
   */
  public Items(
      String id, String what, String whenEmpty, Model<T> model, Function<T, String> words) {
    this.id = id;
    this.model = model;
    this.words = words;
    problem = new Remark(id + "-problem", Palette::error);
    empty = new Remark(id + "-empty", Palette::quiet);
    empty.say(whenEmpty);
    form = new PartsForm<>(id, this::refusal, this::replace);
    TitledCard.named(list, id + "-list", what);
    list.setVisibleRowCount(ROWS);
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setCellRenderer(new Cell());
    list.addListSelectionListener(
        event -> {
          if (!showing && !event.getValueIsAdjusting()) {
            choose(list.getSelectedIndex());
          }
        });
    list.getInputMap().put(KeyStroke.getKeyStroke("DELETE"), "remove");
    list.getActionMap()
        .put(
            "remove",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                remove();
              }
            });
    TitledCard.named(remove, id + "-remove", text("removeTheChosenOne"));
    remove.addActionListener(event -> remove());
    TitledCard.named(up, id + "-up", text("moveTheChosenOneUp"));
    up.addActionListener(event -> move(-1));
    TitledCard.named(down, id + "-down", text("moveTheChosenOneDown"));
    down.addActionListener(event -> move(1));
    TitledCard.compact(remove, up, down);
    buttons.setOpaque(false);
    panel.setOpaque(false);
    JScrollPane scroll = InnerScroll.of(new JScrollPane(list));
    ShownFocus.of(list, scroll);
    panel.add(scroll, "hmin 60");
    panel.add(buttons, "wmin 0, pad 0 -" + PartsForm.BETWEEN + " 0 0");
    panel.add(empty, Remark.LAYOUT);
    panel.add(problem, Remark.LAYOUT);
    panel.add(form.component(), "gaptop 6");
  }

  /**
   * A button that adds one.
   *
   * @param word with which its name ends
   */
  public Items<T> adder(String word, String title, Supplier<T> fresh) {
    return asker(word, title, take -> take.accept(fresh.get()));
  }

  /**
   * A button that adds one after it has asked for more.
   *
   * @param word with which its name ends
   * @param ask is handed what adds one
   */
  public Items<T> asker(String word, String title, Consumer<Consumer<T>> ask) {
    JButton button = new JButton(title);
    TitledCard.named(button, id + "-" + word, title);
    TitledCard.compact(button);
    button.addActionListener(event -> ask.accept(this::add));
    adders.add(button);
    buttons.add(button, adders.size() - 1);
    return this;
  }

  /**
   * A button with a menu of what it adds, for many kinds.
   *
   * @param kinds of things, in their order
   */
  public Items<T> adders(String title, List<Kind<T>> kinds) {
    JButton button = TitledCard.named(new JButton(title + " \u25be"), id + "-add", title);
    TitledCard.compact(button);
    JPopupMenu menu = new JPopupMenu();
    for (Kind<T> kind : kinds) {
      JMenuItem entry =
          TitledCard.named(new JMenuItem(kind.title()), id + "-add-" + kind.word(), kind.title());
      entry.addActionListener(event -> add(kind.fresh().get()));
      menu.add(entry);
    }
    button.addActionListener(event -> menu.show(button, 0, button.getHeight()));
    adders.add(button);
    buttons.add(button, adders.size() - 1);
    return this;
  }

  /** The form for the chosen one, to be filled with fields. */
  public PartsForm<T> form() {
    return form;
  }

  public JComponent component() {
    if (remove.getParent() == null) {
      buttons.add(WrappingRow.together(PartsForm.BETWEEN, remove, up, down));
    }
    return panel;
  }

  /** The chosen one. */
  public Optional<T> chosen() {
    List<T> all = model.list();
    return chosen >= 0 && chosen < all.size() ? Optional.of(all.get(chosen)) : Optional.empty();
  }

  /** The place of the chosen one; -1 for none. */
  public int chosenIndex() {
    return chosen().isPresent() ? chosen : -1;
  }

  /** A name that none has: the word with a number behind it. */
  public String freshName(String word) {
    for (int i = 1; ; i++) {
      String name = word + "_" + i;
      if (model.list().stream().map(words).noneMatch(each -> each.startsWith(name))) {
        return name;
      }
    }
  }

  /** Changes the chosen one. */
  public void replace(T after) {
    chosen()
        .ifPresent(
            before -> {
              List<T> next = new ArrayList<>(model.list());
              next.set(chosen, after);
              attempt(next, Optional.of(before), Optional.of(after));
            });
  }

  private String refusal(T after) {
    if (chosen().isEmpty()) {
      return "";
    }
    List<T> next = new ArrayList<>(model.list());
    next.set(chosen, after);
    return model.refusal(next);
  }

  private void add(T fresh) {
    List<T> next = new ArrayList<>(model.list());
    next.add(fresh);
    int before = chosen;
    chosen = next.size() - 1;
    if (attempt(next, Optional.empty(), Optional.of(fresh))) {
      show(true);
      focusForm();
    } else {
      chosen = before;
    }
  }

  /** What is new gets a name first. */
  private void focusForm() {
    for (Component each : form.component().getComponents()) {
      if (each instanceof EntryField field) {
        field.requestFocusInWindow();
        field.selectAll();
        return;
      }
    }
  }

  private void remove() {
    chosen()
        .filter(before -> model.editable())
        .ifPresent(
            before -> {
              List<T> next = new ArrayList<>(model.list());
              next.remove(chosen);
              inForm = -1;
              if (attempt(next, Optional.of(before), Optional.empty())) {
                chosen = Math.min(chosen, next.size() - 1);
                show(true);
              }
            });
  }

  private void move(int by) {
    int to = chosen + by;
    List<T> next = new ArrayList<>(model.list());
    if (chosen().isPresent() && to >= 0 && to < next.size()) {
      next.add(to, next.remove(chosen));
      int before = chosen;
      chosen = to;
      if (!attempt(next, Optional.empty(), Optional.empty())) {
        chosen = before;
      }
    }
  }

  private boolean attempt(List<T> next, Optional<T> before, Optional<T> after) {
    String why = Messages.shown(model.refusal(next));
    problem.say(why);
    if (why.isEmpty()) {
      model.take(next, before, after);
    }
    return why.isEmpty();
  }

  /** Chooses one, as people do in the list. */
  public void choose(T item) {
    choose(model.list().indexOf(item));
  }

  private void choose(int index) {
    if (index != chosen) {
      chosen = index;
      problem.say("");
      show(true);
    }
  }

  /** Shows all of them as they are now. */
  public void show() {
    show(false);
  }

  private void show(boolean other) {
    List<T> all = model.list();
    showing = true;
    if (!all.equals(java.util.Collections.list(shown.elements()))) {
      shown.clear();
      all.forEach(shown::addElement);
    }
    boolean moved = chosen >= all.size() || (chosen < 0 && !all.isEmpty());
    if (moved) {
      chosen = chosen < 0 && !all.isEmpty() ? 0 : all.size() - 1;
    }
    if (list.getSelectedIndex() != chosen) {
      list.setSelectedIndex(chosen);
      list.ensureIndexIsVisible(chosen);
    }
    showing = false;
    list.repaint();
    boolean editable = model.editable();
    adders.forEach(each -> each.setEnabled(editable));
    remove.setEnabled(editable && chosen >= 0);
    up.setEnabled(editable && chosen > 0);
    down.setEnabled(editable && chosen >= 0 && chosen < all.size() - 1);
    empty.setVisible(all.isEmpty());
    form.component().setVisible(chosen().isPresent());
    chosen()
        .ifPresent(
            now -> {
              if (other || moved || chosen != inForm) {
                inForm = chosen;
                form.showOther(now);
              } else {
                form.show(now);
              }
            });
  }

  /** Rows for as many things, however many there are: the first one moves nothing below. */
  @SuppressWarnings("serial") // never written to a stream
  private final class Rows extends JList<T> {
    Rows() {
      super(shown);
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
      Dimension size = super.getPreferredScrollableViewportSize();
      if (shown.isEmpty()) {
        Component row =
            new DefaultListCellRenderer().getListCellRendererComponent(this, " ", 0, false, false);
        Insets around = getInsets();
        size.height = ROWS * row.getPreferredSize().height + around.top + around.bottom;
      }
      return size;
    }
  }

  /** What one is called. */
  @SuppressWarnings("serial") // never written to a stream
  private final class Cell extends DefaultListCellRenderer {
    @Override
    @SuppressWarnings("unchecked") // the list holds nothing else
    public Component getListCellRendererComponent(
        JList<?> of, Object item, int index, boolean selected, boolean focused) {
      Component cell = super.getListCellRendererComponent(of, item, index, selected, focused);
      ((JLabel) cell).setText(words.apply((T) item));
      return cell;
    }
  }
}
