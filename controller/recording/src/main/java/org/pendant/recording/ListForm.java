package org.pendant.recording;

import java.util.ArrayList;
import java.util.List;

/** Form of a list: how many, then each. */
final class ListForm<T> extends Form<List<T>> {
  private final Form<T> element;

  ListForm(Form<T> element) {
    this.element = element;
  }

  @Override
  void write(List<T> value, ByteSink out) {
    out.count(value.size());
    for (T each : value) {
      element.write(each, out);
    }
  }

  @Override
  List<T> read(ByteSource in) throws MalformedBytes {
    int count = in.count(1);
    if (count == 0) {
      return List.of();
    }
    // not as many as are announced: what follows may be shorter than that
    List<T> list = new ArrayList<>(Math.min(count, 64));
    for (int i = 0; i < count; i++) {
      list.add(element.read(in));
    }
    return List.copyOf(list);
  }
}
