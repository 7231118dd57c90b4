package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.DefaultListModel;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListCellRenderer;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.action.FuzzyMatch;
import org.pendant.kit.layout.FloatingPanel;
import org.pendant.kit.theme.Palette;

/**
 * Quick pick: finds one of many things by a few letters of its name: ENTER takes it, ESCAPE leaves.
 */
final class QuickPick {
  private static final int ROWS = 12;
  private static final int MAX_SHOWN = 200;
  private static final int WIDTH = 460;

  private final ScriptArea area;
  private final JTextField query = new JTextField();
  private final DefaultListModel<Item> model = new DefaultListModel<>();
  private final JList<Item> list = new JList<>(model);
  private final JLabel nothing = new JLabel(text("nothingMatches"));
  private final FloatingPanel overlay;
  private final List<Item> all = new ArrayList<>();
  private volatile boolean open = true;

  /**
   * Something that can be chosen.
   *
   * @param detail less important, such as where it is
   */
  record Item(String title, String detail, Runnable chosen) {}

  private QuickPick(ScriptArea area, String question, List<Item> items) {
    this.area = area;
    all.addAll(items);
    JPanel content =
        new JPanel(
            new MigLayout("insets 8, gap 6, wrap 1, hidemode 3", "[grow, fill, " + WIDTH + "]"));
    query.setName("pick-query");
    query.putClientProperty("JTextField.placeholderText", question);
    query.setToolTipText(text("aFewLettersOfTheName"));
    query.getAccessibleContext().setAccessibleName(question);
    list.setName("pick-list");
    list.getAccessibleContext().setAccessibleName(question);
    list.setToolTipText(text("enterOrAClickGoesThere"));
    list.setFocusable(false);
    list.setVisibleRowCount(ROWS);
    list.putClientProperty(
        "FlatLaf.style",
        "selectionInactiveBackground: $List.selectionBackground;"
            + " selectionInactiveForeground: $List.selectionForeground");
    list.setCellRenderer(new Cell());
    nothing.setForeground(Palette.quiet());
    content.add(query);
    content.add(new JScrollPane(list));
    content.add(nothing);
    overlay = new FloatingPanel(area, content);
    listen();
  }

  private void listen() {
    query.getDocument().addDocumentListener(new Typed());
    key("UP", () -> move(-1));
    key("DOWN", () -> move(1));
    key("PAGE_UP", () -> move(1 - ROWS));
    key("PAGE_DOWN", () -> move(ROWS - 1));
    key("ESCAPE", this::leave);
    query.addActionListener(event -> take());
    query.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            if (!event.isTemporary()) {
              hide();
            }
          }
        });
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            list.setSelectedIndex(list.locationToIndex(event.getPoint()));
            take();
          }
        });
  }

  private void key(String keys, Runnable run) {
    query.getInputMap().put(KeyStroke.getKeyStroke(keys), keys);
    query
        .getActionMap()
        .put(
            keys,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }

  /** Asks over the text of {@code area}; more items may be added while it is open. */
  static QuickPick ask(ScriptArea area, String question, List<Item> items) {
    QuickPick pick = new QuickPick(area, question, items);
    pick.filter();
    pick.show();
    pick.query.requestFocusInWindow();
    return pick;
  }

  /** Adds what was found meanwhile. */
  void add(List<Item> items) {
    all.addAll(items);
    if (overlay.visible()) {
      filter();
    }
  }

  /** Says why there is not more. */
  void say(String reason) {
    nothing.setText(reason);
    nothing.setVisible(true);
  }

  /** Whether the user still looks; any thread may ask. */
  boolean open() {
    return open;
  }

  private void show() {
    Rectangle seen = area.getVisibleRect();
    int x = seen.x + Math.max(0, (seen.width - UIScale.scale(WIDTH)) / 2);
    overlay.show(new Rectangle(x, seen.y, 0, 0), false);
  }

  private void filter() {
    List<Item> found = FuzzyMatch.filter(query.getText(), all, Item::title);
    model.clear();
    model.addAll(found.subList(0, Math.min(MAX_SHOWN, found.size())));
    nothing.setVisible(found.isEmpty());
    list.setVisibleRowCount(Math.clamp(all.size(), 3, ROWS));
    if (!found.isEmpty()) {
      list.setSelectedIndex(0);
      list.ensureIndexIsVisible(0);
    }
  }

  private void move(int rows) {
    if (!model.isEmpty()) {
      int to = Math.clamp((long) list.getSelectedIndex() + rows, 0, model.size() - 1);
      list.setSelectedIndex(to);
      list.ensureIndexIsVisible(to);
    }
  }

  private void leave() {
    area.requestFocusInWindow();
    hide();
  }

  private void hide() {
    open = false;
    overlay.hide();
  }

  private void take() {
    Item chosen = list.getSelectedValue();
    if (chosen != null) {
      leave();
      chosen.chosen().run();
    }
  }

  /** Title and detail in one row. */
  private static final class Cell implements ListCellRenderer<Item> {
    private final JPanel row =
        new JPanel(new MigLayout("insets 3 8 3 8, fillx", "[][grow, right]"));
    private final JLabel title = new JLabel();
    private final JLabel detail = new JLabel();

    Cell() {
      row.add(title);
      row.add(detail, "wmin 0");
    }

    @Override
    public Component getListCellRendererComponent(
        JList<? extends Item> all, Item item, int index, boolean selected, boolean focus) {
      row.setBackground(selected ? all.getSelectionBackground() : all.getBackground());
      title.setText(item.title());
      title.setForeground(selected ? all.getSelectionForeground() : all.getForeground());
      detail.setText(item.detail());
      detail.setForeground(selected ? all.getSelectionForeground() : Palette.quiet());
      row.getAccessibleContext().setAccessibleName(item.title() + " " + item.detail());
      return row;
    }
  }

  /** Filters while letters are typed. */
  private final class Typed implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
      filter();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
      filter();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {}
  }
}
