package org.pendant.desktop.program;

import java.util.Collection;
import java.util.OptionalLong;
import java.util.Set;

/** List selection: the nodes that are selected in a list, for commands. */
record ListSelection(TreeList list) implements TreeCommands.Selection {
  @Override
  public Set<Long> selected() {
    return list.selected();
  }

  @Override
  public OptionalLong lead() {
    return list.lead();
  }

  @Override
  public void select(Collection<Long> keys) {
    list.select(keys);
  }
}
