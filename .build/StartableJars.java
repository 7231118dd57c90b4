import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassFile.ClassHierarchyResolverOption;
import java.lang.classfile.ClassHierarchyResolver;
import java.lang.classfile.ClassModel;
import java.lang.classfile.ClassTransform;
import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.instruction.InvokeDynamicInstruction;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.DirectMethodHandleDesc;
import java.lang.constant.MethodTypeDesc;
import java.lang.reflect.AccessFlag;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.jar.Attributes;
import java.util.jar.Attributes.Name;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;

/**
 * Jars that start fast: rewrites those in the given folder, so that the AOT cache can hold all that
 * a start needs. The JVM makes the code behind a pattern switch and that of {@code equals} and
 * {@code hashCode} of a record when it first comes there, and keeps none of it in a cache; here it
 * is written into the class files, with the same results. Jars lose their signatures, since classes
 * of signed jars are not kept either, and checking them takes longer than everything else. Of their
 * manifests remains what the JVM and Pendant ask for: those of all jars with a class in the cache
 * are read at each start, and most of what they tell is for OSGi. {@code pendant.jar} becomes a
 * start jar that has nothing but a class path, with the jar of the arms first and what it had
 * itself second: jars are opened in that order until a file is found, and the arms are what a run
 * reads. The files of texts that the window and commands speak become {@linkplain TextClasses
 * classes}, which the cache can hold, and fonts lie in their jars as they are.
 */
final class StartableJars {
  private static final String OURS = "org/pendant/";

  /** What a run reads files from, in the class path. */
  private static final String READ_FIRST = "lib/pendant-models-";

  /** Where what was in the start jar is, in the class path. */
  private static final String DESKTOP = "lib/pendant-desktop.jar";

  private static final MethodTypeDesc HASH =
      MethodTypeDesc.of(ConstantDescs.CD_int, ConstantDescs.CD_Object);
  private static final MethodTypeDesc EQUAL =
      MethodTypeDesc.of(ConstantDescs.CD_boolean, ConstantDescs.CD_Object, ConstantDescs.CD_Object);

  /** What stays in manifests. */
  private static final Set<Name> NEEDED =
      Set.of(
          Name.MANIFEST_VERSION,
          Name.MAIN_CLASS,
          Name.CLASS_PATH,
          Name.MULTI_RELEASE,
          Name.IMPLEMENTATION_VERSION,
          new Name("Enable-Native-Access"));

  private static final ClassDesc OBJECTS = ClassDesc.ofDescriptor(Objects.class.descriptorString());

  /** What a pattern switch selects by: the first type from a number on that a value has. */
  private record Selector(String name, MethodTypeDesc type, List<ClassDesc> types) {}

  private final ClassFile files;
  private final TextClasses texts;

  private StartableJars(ClassLoader classes, TextClasses texts) {
    this.texts = texts;
    files =
        ClassFile.of(
            ClassHierarchyResolverOption.of(
                ClassHierarchyResolver.ofResourceParsing(classes)
                    .orElse(ClassHierarchyResolver.defaultResolver())));
  }

  public static void main(String[] folder) throws IOException {
    List<Path> jars;
    try (Stream<Path> all = Files.walk(Path.of(folder[0]))) {
      jars = all.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
    }
    URL[] urls = jars.stream().map(StartableJars::url).toArray(URL[]::new);
    TextClasses texts = new TextClasses();
    for (Path jar : jars) {
      gatherTexts(jar, texts);
    }
    try (URLClassLoader classes = new URLClassLoader(urls)) {
      StartableJars rewriting = new StartableJars(classes, texts);
      for (Path jar : jars) {
        rewriting.rewrite(jar);
      }
    }
    Path start = Path.of(folder[0], "pendant.jar");
    if (Files.exists(start)) {
      makeStartJar(start);
    }
  }

  private static void gatherTexts(Path jar, TextClasses texts) throws IOException {
    try (ZipFile in = new ZipFile(jar.toFile())) {
      for (ZipEntry entry :
          (Iterable<ZipEntry>) in.stream().<ZipEntry>map(each -> each)::iterator) {
        if (TextClasses.isBundle(entry.getName())) {
          texts.add(entry.getName(), in.getInputStream(entry));
        }
      }
    }
  }

  private static void makeStartJar(Path jar) throws IOException {
    Manifest manifest;
    long time;
    try (JarFile in = new JarFile(jar.toFile())) {
      manifest = in.getManifest();
      time = in.getEntry(JarFile.MANIFEST_NAME).getTime();
    }
    Attributes attributes = manifest.getMainAttributes();
    List<String> others = List.of(attributes.getValue(Name.CLASS_PATH).split(" "));
    List<String> first = others.stream().filter(each -> each.startsWith(READ_FIRST)).toList();
    List<String> path = new ArrayList<>(first);
    path.add(DESKTOP);
    others.stream().filter(each -> !first.contains(each)).forEach(path::add);
    attributes.put(Name.CLASS_PATH, String.join(" ", path));
    Path start = Path.of(jar + ".new");
    try (OutputStream file = Files.newOutputStream(start);
        JarOutputStream out = new JarOutputStream(file)) {
      write(manifest, time, out);
    }
    withoutClassPath(jar, jar.resolveSibling(DESKTOP));
    Files.move(start, jar, StandardCopyOption.REPLACE_EXISTING);
  }

  /** Copies a jar, whose class path would be looked for in its new folder. */
  private static void withoutClassPath(Path jar, Path copy) throws IOException {
    try (JarFile in = new JarFile(jar.toFile());
        OutputStream file = Files.newOutputStream(copy)) {
      Manifest manifest = in.getManifest();
      manifest.getMainAttributes().remove(Name.CLASS_PATH);
      try (JarOutputStream out = new JarOutputStream(file)) {
        write(manifest, in.getEntry(JarFile.MANIFEST_NAME).getTime(), out);
        for (JarEntry entry : (Iterable<JarEntry>) in.stream()::iterator) {
          if (!isManifest(entry)) {
            JarEntry same = new JarEntry(entry.getName());
            same.setTime(entry.getTime());
            out.putNextEntry(same);
            in.getInputStream(entry).transferTo(out);
          }
        }
      }
    }
  }

  /** Writes a manifest with a time of its own: left to itself, the stream takes the time of day. */
  private static void write(Manifest manifest, long time, JarOutputStream out) throws IOException {
    JarEntry entry = new JarEntry(JarFile.MANIFEST_NAME);
    entry.setTime(time);
    out.putNextEntry(entry);
    manifest.write(out);
    out.closeEntry();
  }

  private static URL url(Path jar) {
    try {
      return jar.toUri().toURL();
    } catch (MalformedURLException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void rewrite(Path jar) throws IOException {
    Path rewritten = Path.of(jar + ".new");
    try (ZipFile in = new ZipFile(jar.toFile())) {
      List<ZipEntry> entries = in.stream().<ZipEntry>map(entry -> entry).toList();
      try (OutputStream file = Files.newOutputStream(rewritten);
          ZipOutputStream out = new ZipOutputStream(file)) {
        for (ZipEntry entry : entries) {
          if (entry.getName().equals(TextClasses.ENTRY)) {
            for (Map.Entry<String, byte[]> type : texts.classes().entrySet()) {
              write(type.getKey(), entry.getTime(), type.getValue(), out);
            }
          } else if (!isSignature(entry) && !TextClasses.isBundle(entry.getName())) {
            byte[] content = in.getInputStream(entry).readAllBytes();
            byte[] written =
                isOurs(entry)
                    ? rewritten(content)
                    : isManifest(entry) ? shortened(content) : content;
            write(entry.getName(), entry.getTime(), written, out);
          }
        }
      }
    }
    Files.move(rewritten, jar, StandardCopyOption.REPLACE_EXISTING);
  }

  private static void write(String name, long time, byte[] content, ZipOutputStream out)
      throws IOException {
    ZipEntry entry = new ZipEntry(name);
    entry.setTime(time);
    if (isFont(name)) {
      CRC32 sum = new CRC32();
      sum.update(content);
      entry.setMethod(ZipEntry.STORED);
      entry.setSize(content.length);
      entry.setCrc(sum.getValue());
    }
    out.putNextEntry(entry);
    out.write(content);
  }

  /** What takes longer to unpack than to read: a start loads ten of half a megabyte. */
  private static boolean isFont(String name) {
    return name.endsWith(".otf") || name.endsWith(".ttf");
  }

  private static boolean isOurs(ZipEntry entry) {
    return entry.getName().startsWith(OURS) && entry.getName().endsWith(".class");
  }

  private static boolean isSignature(ZipEntry entry) {
    return entry.getName().matches("META-INF/[^/]*\\.(SF|RSA|DSA|EC)");
  }

  private static boolean isManifest(ZipEntry entry) {
    return entry.getName().equals(JarFile.MANIFEST_NAME);
  }

  private static byte[] shortened(byte[] content) throws IOException {
    Manifest manifest = new Manifest(new ByteArrayInputStream(content));
    manifest.getEntries().clear();
    manifest.getMainAttributes().keySet().retainAll(NEEDED);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    manifest.write(out);
    return out.toByteArray();
  }

  private byte[] rewritten(byte[] content) {
    ClassModel model = files.parse(content);
    ClassDesc self = model.thisClass().asSymbol();
    boolean isInterface = model.flags().has(AccessFlag.INTERFACE);
    List<Selector> selectors = new ArrayList<>();
    ClassTransform calls =
        ClassTransform.transformingMethodBodies(
            (code, element) -> {
              if (!(element instanceof InvokeDynamicInstruction call)) {
                code.with(element);
              } else if (isBootstrap(call, "SwitchBootstraps", "typeSwitch")
                  && call.bootstrapArgs().stream().allMatch(ClassDesc.class::isInstance)) {
                Selector selector =
                    new Selector(
                        "select$" + selectors.size(),
                        call.typeSymbol(),
                        call.bootstrapArgs().stream().map(ClassDesc.class::cast).toList());
                selectors.add(selector);
                code.invokestatic(self, selector.name(), selector.type(), isInterface);
              } else if (isBootstrap(call, "ObjectMethods", "bootstrap")
                  && call.name().equalsString("hashCode")) {
                hashCode(code, components(call));
              } else if (isBootstrap(call, "ObjectMethods", "bootstrap")
                  && call.name().equalsString("equals")) {
                equals(code, self, components(call));
              } else {
                code.with(element);
              }
            });
    return files.transformClass(
        model,
        calls.andThen(
            ClassTransform.endHandler(
                type ->
                    selectors.forEach(
                        selector ->
                            type.withMethodBody(
                                selector.name(),
                                selector.type(),
                                ClassFile.ACC_PRIVATE
                                    | ClassFile.ACC_STATIC
                                    | ClassFile.ACC_SYNTHETIC,
                                code -> select(code, selector.types()))))));
  }

  private static boolean isBootstrap(InvokeDynamicInstruction call, String type, String method) {
    return call.bootstrapMethod().owner().displayName().equals(type)
        && call.bootstrapMethod().methodName().equals(method);
  }

  /** The fields of a record; before them the bootstrap's arguments have its type and its names. */
  private static List<DirectMethodHandleDesc> components(InvokeDynamicInstruction call) {
    return call.bootstrapArgs().stream().skip(2).map(DirectMethodHandleDesc.class::cast).toList();
  }

  /** The number of the first of {@code types}, from the second argument on, of the first one. */
  private static void select(CodeBuilder code, List<ClassDesc> types) {
    Label present = code.newLabel();
    code.aload(0).ifnonnull(present).iconst_m1().ireturn().labelBinding(present);
    for (int i = 0; i < types.size(); i++) {
      Label other = code.newLabel();
      code.iload(1).loadConstant(i).if_icmpgt(other);
      code.aload(0).instanceOf(types.get(i)).ifeq(other);
      code.loadConstant(i).ireturn().labelBinding(other);
    }
    code.loadConstant(types.size()).ireturn();
  }

  /** Replaces the record on the stack by its hash code. */
  private static void hashCode(CodeBuilder code, List<DirectMethodHandleDesc> components) {
    code.pop().iconst_0();
    for (DirectMethodHandleDesc component : components) {
      ClassDesc type = component.invocationType().returnType();
      code.bipush(31).imul();
      code.aload(0).getfield(component.owner(), component.methodName(), type);
      if (type.isPrimitive()) {
        code.invokestatic(boxed(type), "hashCode", MethodTypeDesc.of(ConstantDescs.CD_int, type));
      } else {
        code.invokestatic(OBJECTS, "hashCode", HASH);
      }
      code.iadd();
    }
  }

  /** Replaces the record and the object on the stack by whether they are equal. */
  private static void equals(
      CodeBuilder code, ClassDesc self, List<DirectMethodHandleDesc> components) {
    Label same = code.newLabel();
    Label different = code.newLabel();
    Label done = code.newLabel();
    code.if_acmpeq(same);
    code.aload(1).instanceOf(self).ifeq(different);
    for (DirectMethodHandleDesc component : components) {
      ClassDesc type = component.invocationType().returnType();
      code.aload(0).getfield(self, component.methodName(), type);
      code.aload(1).checkcast(self).getfield(self, component.methodName(), type);
      if (type.isPrimitive()) {
        MethodTypeDesc compare = MethodTypeDesc.of(ConstantDescs.CD_int, type, type);
        code.invokestatic(boxed(type), "compare", compare).ifne(different);
      } else {
        code.invokestatic(OBJECTS, "equals", EQUAL).ifeq(different);
      }
    }
    code.labelBinding(same).iconst_1().goto_(done);
    code.labelBinding(different).iconst_0();
    code.labelBinding(done);
  }

  private static ClassDesc boxed(ClassDesc primitive) {
    return switch (primitive.descriptorString()) {
      case "Z" -> ConstantDescs.CD_Boolean;
      case "B" -> ConstantDescs.CD_Byte;
      case "S" -> ConstantDescs.CD_Short;
      case "C" -> ConstantDescs.CD_Character;
      case "I" -> ConstantDescs.CD_Integer;
      case "J" -> ConstantDescs.CD_Long;
      case "F" -> ConstantDescs.CD_Float;
      case "D" -> ConstantDescs.CD_Double;
      default -> throw new IllegalArgumentException(primitive + " is no primitive type");
    };
  }
}
