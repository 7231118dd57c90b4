/**
 * Builtins: the functions and methods that a script may call, one class a topic, each function
 * declared once beside its code. Open {@link org.pendant.controller.builtin.StandardBuiltins}
 * first, it lists the topics.
 */
package org.pendant.controller.builtin;
