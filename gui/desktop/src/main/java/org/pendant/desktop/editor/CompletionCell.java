package org.pendant.desktop.editor;

import java.awt.Component;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.theme.Palette;
import org.pendant.language.service.Completion;
import org.pendant.language.source.ByteText;

/** Completion cell: one line of the list of completions: kind, name, and what it takes. */
@SuppressWarnings("serial") // never written to a stream
final class CompletionCell extends JPanel implements ListCellRenderer<Completion> {
  private final JLabel name = new JLabel();
  private final JLabel detail = new JLabel();

  CompletionCell() {
    super(new MigLayout("insets 1 6 1 8, gap 8, fillx", "[][grow,right]"));
    name.setFont(EditorTheme.codeFont());
    add(name);
    add(detail, "wmin 0, wmax 260");
  }

  @Override
  public Component getListCellRendererComponent(
      JList<? extends Completion> list,
      Completion completion,
      int index,
      boolean selected,
      boolean focused) {
    setBackground(selected ? list.getSelectionBackground() : list.getBackground());
    name.setForeground(selected ? list.getSelectionForeground() : list.getForeground());
    detail.setForeground(selected ? list.getSelectionForeground() : Palette.quiet());
    name.setIcon(KindIcon.of(completion.kind()));
    name.setText(ByteText.decoded(completion.label()));
    detail.setText(ByteText.decoded(shown(completion)));
    return this;
  }

  /** Heads of functions stand in the panel beside the list. */
  private static String shown(Completion completion) {
    return switch (completion.kind()) {
      case BUILTIN, FUNCTION, METHOD, THREAD -> "";
      case ARGUMENT -> completion.detail().substring(completion.detail().indexOf(' ') + 1);
      default -> completion.detail();
    };
  }
}
