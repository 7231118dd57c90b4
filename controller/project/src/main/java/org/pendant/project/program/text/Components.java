package org.pendant.project.program.text;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;

/** Record components: takes records apart and puts them together. */
final class Components {
  private static final ClassValue<Boolean> USUAL =
      new ClassValue<>() {
        @Override
        protected Boolean computeValue(Class<?> variant) {
          return usual(variant.getInterfaces()[0]) == variant;
        }
      };

  private Components() {}

  /** The value of one component. */
  static Object get(Record of, RecordComponent component) {
    try {
      return component.getAccessor().invoke(of);
    } catch (IllegalAccessException | InvocationTargetException e) {
      throw new IllegalStateException("components of public records can be read", e);
    }
  }

  /** A record of these values. */
  static <R extends Record> R make(Class<R> type, Object... values) {
    Class<?>[] types =
        Arrays.stream(type.getRecordComponents())
            .map(RecordComponent::getType)
            .toArray(Class<?>[]::new);
    try {
      return type.getDeclaredConstructor(types).newInstance(values);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("steps take whatever their components may be", e);
    }
  }

  /** Whether a variant is the one that needs not be written: the first, without components. */
  static boolean usual(Record variant) {
    return USUAL.get(variant.getClass());
  }

  /** The variant that is meant where none is written; null if one must be. */
  static Class<?> usual(Class<?> family) {
    Class<?> first = family.getPermittedSubclasses()[0];
    return first.getRecordComponents().length == 0 ? first : null;
  }
}
