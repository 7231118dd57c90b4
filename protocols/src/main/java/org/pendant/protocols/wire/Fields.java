package org.pendant.protocols.wire;

import java.util.LinkedHashMap;
import java.util.Map;

/** Fields: the parts of a message in their order. */
public final class Fields {
  private Fields() {}

  /** One part. */
  public static Map<String, Object> of(String name, Object value) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put(name, value);
    return fields;
  }

  /** Two parts. */
  public static Map<String, Object> of(String name, Object value, String other, Object second) {
    Map<String, Object> fields = of(name, value);
    fields.put(other, second);
    return fields;
  }
}
