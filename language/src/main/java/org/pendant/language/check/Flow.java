package org.pendant.language.check;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Branch;
import org.pendant.language.syntax.Statement.If;
import org.pendant.language.syntax.Statement.While;

/**
 * Data flow: what has happened to a function's variables on the path to the statement being
 * checked: those that may have a value on some path, and the kinds of those assigned on every path.
 */
final class Flow {
  private final Set<Binding> mayBeAssigned = new HashSet<>();
  private final List<Binding> assignedLog = new ArrayList<>();
  private final Map<Binding, StaticType> kinds = new HashMap<>();
  private final List<Binding> kindLog = new ArrayList<>();

  /** The state before an {@code if}, to which each branch returns. */
  static final class Fork {
    private final int assigned;
    private final int kinds;
    private final List<Binding> assignedInBranches = new ArrayList<>();

    private Fork(int assigned, int kinds) {
      this.assigned = assigned;
      this.kinds = kinds;
    }
  }

  void assigned(Binding binding) {
    if (mayBeAssigned.add(binding)) {
      assignedLog.add(binding);
    }
  }

  boolean mayBeAssigned(Binding binding) {
    return mayBeAssigned.contains(binding);
  }

  /** Notes that {@code binding} holds {@code kind} from here to the end of the block. */
  void holds(Binding binding, StaticType kind) {
    if (kind.certain() && kinds.putIfAbsent(binding, kind) == null) {
      kindLog.add(binding);
    }
  }

  /** What every path to here has put into {@code binding}. */
  StaticType kind(Binding binding) {
    return kinds.getOrDefault(binding, StaticType.ANY);
  }

  Fork fork() {
    return new Fork(assignedLog.size(), kindLog.size());
  }

  /** Ends one branch: the next starts from the state before the fork. */
  void endBranch(Fork fork) {
    while (assignedLog.size() > fork.assigned) {
      Binding binding = assignedLog.removeLast();
      mayBeAssigned.remove(binding);
      fork.assignedInBranches.add(binding);
    }
    forgetKinds(fork);
  }

  /** After the last branch: what any branch has assigned may be assigned. */
  void join(Fork fork) {
    fork.assignedInBranches.forEach(this::assigned);
  }

  /** Ends a block that may have run or not. */
  void forgetKinds(Fork fork) {
    while (kindLog.size() > fork.kinds) {
      kinds.remove(kindLog.removeLast());
    }
  }

  /** At the head of a loop: its later statements may have run in an earlier turn. */
  void assignedIn(FunctionScope scope, List<Statement> loopBody) {
    for (Statement statement : loopBody) {
      if (statement instanceof Assign assign && assign.target() instanceof Name) {
        assigned(scope.target(assign));
      } else if (statement instanceof If choice) {
        for (Branch branch : choice.branches()) {
          assignedIn(scope, branch.body());
        }
        choice.otherwise().ifPresent(body -> assignedIn(scope, body));
      } else if (statement instanceof While loop) {
        assignedIn(scope, loop.body());
      }
    }
  }
}
