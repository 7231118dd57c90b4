package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.ListSelectionModel;
import javax.swing.Popup;
import javax.swing.PopupFactory;
import org.pendant.desktop.editor.text.Edit;
import org.pendant.desktop.editor.text.Insertion;
import org.pendant.kit.theme.Palette;
import org.pendant.language.service.Completion;
import org.pendant.language.source.ByteText;

/**
 * Field completions: a list of completions under a field with an expression: CTRL SPACE, or by
 * itself for names.
 */
public final class FieldCompletions {
  private static final int ROWS = 8;

  private final JTextField field;
  private final Runnable wanted;
  private final JList<Completion> list = new JList<>();
  private Optional<Popup> popup = Optional.empty();

  /**
   * Nothing is offered yet.
   *
   * @param wanted asked for completions, which {@link #offer} takes
   */
  public FieldCompletions(JTextField field, Runnable wanted) {
    this.field = field;
    this.wanted = wanted;
    list.setName("condition-completions");
    list.getAccessibleContext().setAccessibleName(text("completions"));
    list.setFocusable(false);
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.putClientProperty(
        "FlatLaf.style",
        "selectionInactiveBackground: $List.selectionBackground;"
            + " selectionInactiveForeground: $List.selectionForeground");
    list.setCellRenderer(new Cell());
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            list.setSelectedIndex(list.locationToIndex(event.getPoint()));
            choose();
            event.consume();
          }
        });
    field.addKeyListener(new Keys());
    field.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            hide();
          }
        });
  }

  /** Shows what may be typed now; nothing closes the list. */
  public void offer(List<Completion> found) {
    String word = field.getText().substring(wordStart(), field.getCaretPosition());
    boolean complete = !found.isEmpty() && found.getFirst().insert().equals(word);
    hide();
    if (found.isEmpty() || complete || !field.isShowing() || !field.hasFocus()) {
      return;
    }
    list.setFont(field.getFont());
    list.setListData(found.toArray(new Completion[0]));
    list.setVisibleRowCount(Math.min(ROWS, found.size()));
    list.setSelectedIndex(0);
    JScrollPane scroll = new JScrollPane(list);
    scroll.setBorder(BorderFactory.createLineBorder(Palette.line()));
    Point corner = field.getLocationOnScreen();
    int height = scroll.getPreferredSize().height;
    // Above the field: below it are rows that people compare with, and often the window ends.
    Popup shown =
        PopupFactory.getSharedInstance().getPopup(field, scroll, corner.x, corner.y - height);
    shown.show();
    popup = Optional.of(shown);
  }

  public boolean visible() {
    return popup.isPresent();
  }

  public void hide() {
    popup.ifPresent(Popup::hide);
    popup = Optional.empty();
  }

  private int wordStart() {
    return Insertion.wordStart(field.getText(), field.getCaretPosition());
  }

  private void choose() {
    Completion chosen = list.getSelectedValue();
    hide();
    if (chosen != null) {
      Insertion insertion =
          Insertion.of(chosen, field.getText(), wordStart(), field.getCaretPosition());
      field.setText(Edit.apply(field.getText(), List.of(insertion.edit())));
      field.setCaretPosition(insertion.caret());
      hide();
    }
  }

  private void move(int rows) {
    int size = list.getModel().getSize();
    list.setSelectedIndex(Math.floorMod(list.getSelectedIndex() + rows, size));
    list.ensureIndexIsVisible(list.getSelectedIndex());
  }

  /** The keys that belong to the list while it is there. */
  private final class Keys extends KeyAdapter {
    @Override
    public void keyPressed(KeyEvent event) {
      if (event.getKeyCode() == KeyEvent.VK_SPACE && event.isControlDown()) {
        wanted.run();
        event.consume();
        return;
      }
      if (!visible()) {
        return;
      }
      boolean taken = true;
      switch (event.getKeyCode()) {
        case KeyEvent.VK_DOWN -> move(1);
        case KeyEvent.VK_UP -> move(-1);
        case KeyEvent.VK_ENTER, KeyEvent.VK_TAB -> choose();
        case KeyEvent.VK_ESCAPE -> hide();
        default -> taken = false;
      }
      if (taken) {
        event.consume();
      }
    }

    @Override
    public void keyTyped(KeyEvent event) {
      char c = event.getKeyChar();
      if (Insertion.isWord(c) && !Character.isDigit(c)) {
        // the character is in the field afterwards
        java.awt.EventQueue.invokeLater(wanted);
      } else if (c != KeyEvent.CHAR_UNDEFINED && !Character.isISOControl(c)) {
        hide();
      }
    }
  }

  /** The name of a completion. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Cell extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      String name = value instanceof Completion each ? ByteText.decoded(each.label()) : "";
      super.getListCellRendererComponent(list, name, index, selected, false);
      return this;
    }
  }
}
