package org.pendant.desktop.program;

import java.util.List;
import javax.swing.AbstractListModel;

/** Tree rows that are not hidden. */
@SuppressWarnings("serial") // never written to a stream
final class TreeRows extends AbstractListModel<TreeRow> {
  private transient List<TreeRow> shown = List.of();

  void show(List<TreeRow> next) {
    int before = shown.size();
    shown = next;
    int after = next.size();
    if (after < before) {
      fireIntervalRemoved(this, after, before - 1);
    } else if (after > before) {
      fireIntervalAdded(this, before, after - 1);
    }
    if (after > 0) {
      fireContentsChanged(this, 0, after - 1);
    }
  }

  List<TreeRow> all() {
    return shown;
  }

  @Override
  public int getSize() {
    return shown.size();
  }

  @Override
  public TreeRow getElementAt(int index) {
    return shown.get(index);
  }
}
