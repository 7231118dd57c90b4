/**
 * What a built-in function is to the machine: its declaration, one call of it, and what it answers.
 * Open {@link org.pendant.controller.call.Builtins} first, then {@link
 * org.pendant.controller.call.Call}.
 */
package org.pendant.controller.call;
