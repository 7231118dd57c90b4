package org.pendant.desktop.program;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;

/**
 * Kept keys: gives the nodes of a tree that was read again the keys that they had, where they are
 * alike.
 */
final class KeptKeys {
  private final Set<Long> used = new HashSet<>();
  private long nextKey;

  private KeptKeys(long nextKey) {
    this.nextKey = nextKey;
  }

  /** {@code now} with the keys of nodes of {@code before} that stand at the same places. */
  static ProgramTree of(ProgramTree before, ProgramTree now) {
    KeptKeys keys = new KeptKeys(Math.max(before.nextKey(), now.nextKey()));
    List<ProgramNode> sections = keys.kept(before.sections(), now.sections());
    return new ProgramTree(now.installation(), now.waypoints(), sections, keys.nextKey);
  }

  private List<ProgramNode> kept(List<ProgramNode> before, List<ProgramNode> now) {
    int start = 0;
    int most = Math.min(before.size(), now.size());
    while (start < most && same(before.get(start), now.get(start))) {
      start++;
    }
    int end = 0;
    while (end < most - start && same(before.get(before.size() - 1 - end), fromEnd(now, end))) {
      end++;
    }
    List<ProgramNode> all = new ArrayList<>();
    for (int i = 0; i < now.size(); i++) {
      boolean behind = i >= now.size() - end;
      int old = behind ? before.size() - now.size() + i : i;
      boolean there = behind || i < start || (old < before.size() - end && alike(before, old, now));
      ProgramNode node = now.get(i);
      List<ProgramNode> below =
          kept(there ? before.get(old).children() : List.of(), node.children());
      long key = there && used.add(before.get(old).key()) ? before.get(old).key() : nextKey++;
      all.add(new ProgramNode(key, node.step(), node.suppressed(), below));
    }
    return all;
  }

  private static boolean alike(List<ProgramNode> before, int index, List<ProgramNode> now) {
    return before.get(index).step().getClass() == now.get(index).step().getClass();
  }

  private static boolean same(ProgramNode a, ProgramNode b) {
    return a.step().equals(b.step());
  }

  private static ProgramNode fromEnd(List<ProgramNode> nodes, int index) {
    return nodes.get(nodes.size() - 1 - index);
  }
}
