package org.pendant.language.check;

import org.pendant.language.syntax.Expression;

/** Assignment targets: what the left side of an assignment is about. */
final class Assignments {
  private Assignments() {}

  /** The innermost receiver: {@code x} in {@code x}, {@code x[1]} and {@code x.a[1].b}. */
  static Expression root(Expression target) {
    Expression at = target;
    while (true) {
      if (at instanceof Expression.Index index) {
        at = index.receiver();
      } else if (at instanceof Expression.Member member) {
        at = member.receiver();
      } else {
        return at;
      }
    }
  }
}
