package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.ProgramNode;

/** The kinds of nodes that can be added: by a click, by Enter, or dragged into the tree. */
@SuppressWarnings("serial") // never written to a stream
final class PalettePanel extends JPanel {
  private final JTextField search = new JTextField();
  private final transient Mouse mouse = new Mouse();
  private final JList<Entry> list =
      new JList<>() {
        // Names that are too long for the palette end in an ellipsis.
        @Override
        public boolean getScrollableTracksViewportWidth() {
          return true;
        }

        // A drag takes a node along and selects no others.
        @Override
        protected void processMouseMotionEvent(MouseEvent event) {
          if (event.getID() == MouseEvent.MOUSE_DRAGGED) {
            mouse.mouseDragged(event);
          } else {
            super.processMouseMotionEvent(event);
          }
        }
      };
  private final transient Consumer<NodeKind> add;
  private final transient Function<NodeKind, ProgramNode> make;
  private final transient TreeDrag drag;

  /** A line of the list. */
  private sealed interface Entry {
    /** The name of a group. */
    record Heading(String title) implements Entry {
      @Override
      public String toString() {
        return title;
      }
    }

    /** Something to add. */
    record Kind(NodeKind kind) implements Entry {
      @Override
      public String toString() {
        return KindTitles.of(kind);
      }
    }
  }

  /**
   * A palette.
   *
   * @param add adds a node of a kind where the tree's selection is
   * @param make a node of a kind, to be dragged
   */
  PalettePanel(Consumer<NodeKind> add, Function<NodeKind, ProgramNode> make, TreeDrag drag) {
    super(new BorderLayout());
    this.add = add;
    this.make = make;
    this.drag = drag;
    setName("program-palette-panel");
    search.setName("program-palette-search");
    search.putClientProperty("JTextField.placeholderText", text("findANode"));
    search.putClientProperty("JTextField.showClearButton", true);
    search.setToolTipText(text("showsOnlyNodesWithThisIn"));
    search.getAccessibleContext().setAccessibleName(text("findAKindOfNode"));
    search.getDocument().addDocumentListener(new Typed(this::fill));
    key(search, "DOWN", this::goToList);
    key(search, "ENTER", this::addFirst);
    key(search, "ESCAPE", () -> search.setText(""));
    list.setName("program-palette");
    list.getAccessibleContext().setAccessibleName(text("nodesToAdd"));
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setCellRenderer(new Cell());
    key(list, "ENTER", this::addSelected);
    list.addMouseListener(mouse);
    list.addListSelectionListener(event -> skipHeading(event.getFirstIndex()));
    fill();
    JPanel head = new JPanel(new BorderLayout());
    head.setBorder(BorderFactory.createEmptyBorder(6, 6, 6, 6));
    head.add(search);
    JScrollPane scroll = new JScrollPane(list);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
    add(head, BorderLayout.NORTH);
    add(scroll);
  }

  private static void key(JComponent on, String keys, Runnable run) {
    on.registerKeyboardAction(
        event -> run.run(), KeyStroke.getKeyStroke(keys), JComponent.WHEN_FOCUSED);
  }

  @Override
  public Dimension getMinimumSize() {
    return new Dimension(UIScale.scale(110), UIScale.scale(120));
  }

  /** Whether nodes can be added. */
  void setUsable(boolean usable) {
    search.setEnabled(usable);
    list.setEnabled(usable);
  }

  /** Goes to the search field. */
  void focus() {
    search.requestFocusInWindow();
    search.selectAll();
  }

  /** The title of a group. */
  static String title(NodeKind.Group group) {
    return switch (group) {
      case BASIC -> text("basic");
      case ADVANCED -> text("advanced");
      case TEMPLATE -> text("templates");
      case SECTION -> text("partsOfTheProgram");
      case GIVEN -> "";
    };
  }

  private void fill() {
    String wanted = search.getText().strip().toLowerCase(Locale.ROOT);
    List<Entry> entries = new ArrayList<>();
    for (NodeKind.Group group : NodeKind.Group.values()) {
      List<NodeKind> kinds =
          group == NodeKind.Group.GIVEN
              ? List.of()
              : NodeKind.in(group).stream()
                  .filter(each -> KindTitles.of(each).toLowerCase(Locale.ROOT).contains(wanted))
                  .toList();
      if (!kinds.isEmpty()) {
        entries.add(new Entry.Heading(title(group)));
        kinds.forEach(each -> entries.add(new Entry.Kind(each)));
      }
    }
    if (entries.isEmpty()) {
      entries.add(new Entry.Heading(text("nothingIsCalledSo")));
    }
    list.setListData(entries.toArray(new Entry[0]));
  }

  private void goToList() {
    list.requestFocusInWindow();
    if (list.getModel().getSize() > 1) {
      list.setSelectedIndex(1);
    }
  }

  private void addFirst() {
    if (list.getModel().getSize() > 1
        && list.getModel().getElementAt(1) instanceof Entry.Kind first) {
      add.accept(first.kind());
    }
  }

  private void addSelected() {
    if (list.getSelectedValue() instanceof Entry.Kind selected) {
      add.accept(selected.kind());
    }
  }

  /** Headings are only passed over. */
  private void skipHeading(int before) {
    int index = list.getSelectedIndex();
    if (index >= 0 && list.getSelectedValue() instanceof Entry.Heading) {
      int step = before == index - 1 || index == 0 ? 1 : -1;
      int next = index + step;
      if (next >= 0 && next < list.getModel().getSize()) {
        list.setSelectedIndex(next);
        list.ensureIndexIsVisible(next);
      } else {
        list.clearSelection();
      }
    }
  }

  private Optional<NodeKind> kindAt(Point point) {
    int index = list.locationToIndex(point);
    boolean on = index >= 0 && list.getCellBounds(index, index).contains(point);
    return on && list.getModel().getElementAt(index) instanceof Entry.Kind there
        ? Optional.of(there.kind())
        : Optional.empty();
  }

  /** Clicks add, drags take along. */
  private final class Mouse extends MouseAdapter {
    private Optional<Point> pressed = Optional.empty();

    @Override
    public void mousePressed(MouseEvent event) {
      pressed =
          list.isEnabled() && SwingUtilities.isLeftMouseButton(event)
              ? Optional.of(event.getPoint())
              : Optional.empty();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
      if (pressed.isPresent()
          && !drag.active()
          && pressed.get().distance(event.getPoint()) > UIScale.scale(5)) {
        kindAt(pressed.get()).ifPresent(kind -> drag.begin(list, List.of(make.apply(kind)), false));
      }
      drag.move(event.getPoint(), (event.getModifiersEx() & InputEvent.CTRL_DOWN_MASK) != 0);
    }

    @Override
    public void mouseReleased(MouseEvent event) {
      if (drag.active()) {
        drag.end();
      } else if (pressed.isPresent() && kindAt(event.getPoint()).equals(kindAt(pressed.get()))) {
        kindAt(event.getPoint()).ifPresent(add);
      }
      pressed = Optional.empty();
    }
  }

  /** Icon and name, or a heading. */
  private static final class Cell extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> from, Object value, int index, boolean selected, boolean focused) {
      boolean heading = value instanceof Entry.Heading;
      super.getListCellRendererComponent(
          from, value, index, selected && !heading, focused && !heading);
      setBorder(BorderFactory.createEmptyBorder(heading && index > 0 ? 9 : 3, 8, 3, 4));
      if (value instanceof Entry.Kind entry) {
        SvgIcon icon = StepIcon.of(entry.kind());
        setIcon(selected ? icon.in(getForeground()) : icon);
        setIconTextGap(UIScale.scale(6));
        setToolTipText(text("addsKind", KindTitles.of(entry.kind())));
        getAccessibleContext().setAccessibleName(text("addKind", KindTitles.of(entry.kind())));
      } else {
        setIcon(null);
        setForeground(Palette.quiet());
        setToolTipText(null);
        getAccessibleContext().setAccessibleName(value.toString());
      }
      return this;
    }
  }
}
