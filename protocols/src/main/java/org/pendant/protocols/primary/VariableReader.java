package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.script.value.Value;

/** Variable reader: puts together what {@link VariablePackages} has cut. One thread uses it. */
final class VariableReader {
  private final List<String> names = new ArrayList<>();
  private final List<Optional<Value>> values = new ArrayList<>();
  private ProgramVariables told = ProgramVariables.NONE;
  private boolean changed;

  /** What is known by now. */
  ProgramVariables told() {
    return told;
  }

  /**
   * Takes a package.
   *
   * @param body what stands behind its size and type
   * @throws RuntimeException if it is cut off, or has values of an unknown type
   */
  void take(ByteBuffer body) {
    body.getLong(); // the time
    byte part = body.get();
    int first = Short.toUnsignedInt(body.getShort());
    if (part == VariablePackages.SETUP) {
      setUp(first, body);
    } else if (part == VariablePackages.UPDATE) {
      update(first, body);
    }
  }

  private void setUp(int first, ByteBuffer body) {
    if (first == 0) {
      names.clear();
      values.clear();
      changed = true;
    }
    byte[] text = new byte[body.remaining()];
    body.get(text);
    String all = new String(text, StandardCharsets.ISO_8859_1);
    int at = first;
    for (String each : all.isEmpty() ? new String[0] : all.split("\n")) {
      set(names, at++, each, "");
    }
  }

  private void update(int first, ByteBuffer body) {
    if (first == 0) {
      told = new ProgramVariables(told.begun() + 1, told.whole(), told.values());
    }
    int at = first;
    while (body.hasRemaining()) {
      set(values, at++, ValueDecoder.decode(body), Optional.empty());
      body.get(); // the line end
      changed = true;
    }
  }

  private static <T> void set(List<T> list, int at, T element, T before) {
    while (list.size() <= at) {
      list.add(before);
    }
    list.set(at, element);
  }

  /** The controller tells something else: what it has told of variables is whole. */
  void pause() {
    if (told.whole() == told.begun()) {
      return;
    }
    told = new ProgramVariables(told.begun(), told.begun(), changed ? named() : told.values());
    changed = false;
  }

  private Map<String, Value> named() {
    Map<String, Value> named = new HashMap<>();
    for (int i = 0; i < Math.min(names.size(), values.size()); i++) {
      String name = names.get(i);
      values.get(i).ifPresent(value -> named.put(name, value));
    }
    return named;
  }
}
