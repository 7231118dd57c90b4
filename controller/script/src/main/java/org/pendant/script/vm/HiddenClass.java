package org.pendant.script.vm;

import java.lang.classfile.ClassFile;
import java.lang.classfile.attribute.CodeAttribute;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;

/**
 * Hidden class: one that was written while a program runs, and goes when nobody has it any more.
 */
final class HiddenClass {
  private HiddenClass() {}

  /** The bytes of the code of the largest method of a class file. */
  static int largestMethod(byte[] classFile) {
    return ClassFile.of().parse(classFile).methods().stream()
        .flatMap(method -> method.code().stream())
        .mapToInt(code -> ((CodeAttribute) code).codeLength())
        .max()
        .orElseThrow();
  }

  /**
   * Defines a class in this package and makes an object of it.
   *
   * @param type what the class is; it has a constructor without parameters
   * @throws IllegalStateException if it is not a valid class
   */
  static <T> T make(byte[] classFile, Class<T> type) {
    try {
      MethodHandles.Lookup defined = MethodHandles.lookup().defineHiddenClass(classFile, true);
      return type.cast(
          defined
              .findConstructor(defined.lookupClass(), MethodType.methodType(void.class))
              .invoke());
    } catch (Throwable e) {
      throw new IllegalStateException("the translation is not a valid class", e);
    }
  }
}
