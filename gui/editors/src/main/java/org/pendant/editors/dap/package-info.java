/** The debug adapter: lets an editor run and debug programs by the Debug Adapter Protocol. */
package org.pendant.editors.dap;
