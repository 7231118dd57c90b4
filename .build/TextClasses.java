import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.lang.classfile.ClassBuilder;
import java.lang.classfile.ClassFile;
import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.instruction.SwitchCase;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * The classes that have the texts of all bundles as constants, in place of {@code
 * org.pendant.text.CompiledTexts}: one that finds a bundle by its name, and one for each language,
 * which is loaded when the first bundle of that language is asked for.
 */
final class TextClasses {
  /** The class that is replaced, as the entry of its jar. */
  static final String ENTRY = "org/pendant/text/CompiledTexts.class";

  private static final String FOLDER = "texts/";
  private static final String SUFFIX = ".properties";
  private static final ClassDesc SELF = ClassDesc.of("org.pendant.text.CompiledTexts");
  private static final ClassDesc TEXTS = ConstantDescs.CD_String.arrayType();
  private static final MethodTypeDesc FIND = MethodTypeDesc.of(TEXTS, ConstantDescs.CD_String);
  private static final MethodTypeDesc ALL = MethodTypeDesc.of(TEXTS);
  private static final MethodTypeDesc HASH = MethodTypeDesc.of(ConstantDescs.CD_int);
  private static final MethodTypeDesc EQUAL =
      MethodTypeDesc.of(ConstantDescs.CD_boolean, ConstantDescs.CD_Object);

  /** Texts by key, by the name of their bundle. */
  private final SortedMap<String, SortedMap<String, String>> bundles = new TreeMap<>();

  /** Whether an entry of a jar is a bundle. */
  static boolean isBundle(String entry) {
    return entry.startsWith(FOLDER) && entry.endsWith(SUFFIX);
  }

  void add(String entry, InputStream file) throws IOException {
    Properties texts = new Properties();
    try (Reader reader = new InputStreamReader(file, StandardCharsets.UTF_8)) {
      texts.load(reader);
    }
    SortedMap<String, String> sorted = new TreeMap<>();
    texts.stringPropertyNames().forEach(key -> sorted.put(key, texts.getProperty(key)));
    bundles.put(entry.substring(FOLDER.length(), entry.length() - SUFFIX.length()), sorted);
  }

  /** The classes, by their entries in the jar. */
  SortedMap<String, byte[]> classes() {
    SortedMap<String, byte[]> classes = new TreeMap<>();
    classes.put(
        ENTRY,
        made(SELF, type -> type.withMethodBody("of", FIND, ClassFile.ACC_STATIC, this::find)));
    Map<ClassDesc, List<String>> ofLanguage = new LinkedHashMap<>();
    bundles
        .keySet()
        .forEach(
            each -> ofLanguage.computeIfAbsent(owner(each), type -> new ArrayList<>()).add(each));
    ofLanguage.forEach(
        (type, names) ->
            classes.put(
                ENTRY.replace(SELF.displayName(), type.displayName()),
                made(type, into -> names.forEach(each -> texts(each, into)))));
    return classes;
  }

  private static byte[] made(ClassDesc type, Consumer<ClassBuilder> content) {
    return ClassFile.of()
        .build(
            type,
            into -> {
              into.withFlags(ClassFile.ACC_FINAL | ClassFile.ACC_SUPER);
              content.accept(into);
            });
  }

  /** The class that has a bundle: {@code desktop.sweep_de} is with the others in German. */
  private static ClassDesc owner(String bundle) {
    int at = bundle.indexOf('_');
    return ClassDesc.of(
        SELF.packageName(), SELF.displayName() + (at < 0 ? "_en" : bundle.substring(at)));
  }

  private static String method(String bundle) {
    return bundle.replace('.', '_');
  }

  /** Returns the bundle that has the name in the argument, or an empty array. */
  private void find(CodeBuilder code) {
    SortedMap<Integer, List<String>> byHash = new TreeMap<>();
    bundles
        .keySet()
        .forEach(
            each -> byHash.computeIfAbsent(each.hashCode(), hash -> new ArrayList<>()).add(each));
    Map<Integer, Label> labels = new LinkedHashMap<>();
    byHash.keySet().forEach(hash -> labels.put(hash, code.newLabel()));
    Label none = code.newLabel();
    code.aload(0).invokevirtual(ConstantDescs.CD_String, "hashCode", HASH);
    code.lookupswitch(
        none,
        labels.entrySet().stream()
            .map(each -> SwitchCase.of(each.getKey(), each.getValue()))
            .toList());
    byHash.forEach(
        (hash, names) -> {
          code.labelBinding(labels.get(hash));
          for (String name : names) {
            Label other = code.newLabel();
            code.aload(0)
                .loadConstant(name)
                .invokevirtual(ConstantDescs.CD_String, "equals", EQUAL);
            code.ifeq(other).invokestatic(owner(name), method(name), ALL).areturn();
            code.labelBinding(other);
          }
          code.goto_(none);
        });
    code.labelBinding(none).iconst_0().anewarray(ConstantDescs.CD_String).areturn();
  }

  private void texts(String bundle, ClassBuilder into) {
    SortedMap<String, String> texts = bundles.get(bundle);
    into.withMethodBody(
        method(bundle),
        ALL,
        ClassFile.ACC_STATIC,
        code -> {
          code.loadConstant(2 * texts.size()).anewarray(ConstantDescs.CD_String);
          int index = 0;
          for (Map.Entry<String, String> each : texts.entrySet()) {
            code.dup().loadConstant(index++).loadConstant(each.getKey()).aastore();
            code.dup().loadConstant(index++).loadConstant(each.getValue()).aastore();
          }
          code.areturn();
        });
  }
}
