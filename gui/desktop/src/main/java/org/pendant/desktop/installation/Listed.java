package org.pendant.desktop.installation;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationParts;
import org.pendant.kit.form.Items;

/**
 * List in the installation.
 *
 * @param get reads it
 * @param put writes it
 * @param follow changes what refers to something that has changed: before and after, if any
 */
record Listed<T>(
    Editing editing,
    Function<Installation, List<T>> get,
    BiConsumer<InstallationParts, List<T>> put,
    Follow<T> follow)
    implements Items.Model<T> {

  /** Changes what refers to something. */
  interface Follow<T> {
    void changed(InstallationParts parts, Optional<T> before, Optional<T> after);
  }

  Listed(
      Editing editing,
      Function<Installation, List<T>> get,
      BiConsumer<InstallationParts, List<T>> put) {
    this(editing, get, put, (parts, before, after) -> {});
  }

  @Override
  public List<T> list() {
    return get.apply(editing.now());
  }

  @Override
  public String refusal(List<T> next) {
    List<T> now = list();
    Optional<T> before = Optional.empty();
    Optional<T> after = Optional.empty();
    // what is referred to by its name may change it
    for (int i = 0; i < now.size() && next.size() == now.size(); i++) {
      if (!now.get(i).equals(next.get(i))) {
        before = Optional.of(now.get(i));
        after = Optional.of(next.get(i));
      }
    }
    if (next.size() < now.size()) {
      before = now.stream().filter(each -> !next.contains(each)).findFirst();
    }
    Optional<T> was = before;
    Optional<T> is = after;
    return editing.refusal(
        parts -> {
          put.accept(parts, next);
          follow.changed(parts, was, is);
        });
  }

  @Override
  public void take(List<T> next, Optional<T> before, Optional<T> after) {
    editing.take(
        parts -> {
          put.accept(parts, next);
          follow.changed(parts, before, after);
        });
  }
}
