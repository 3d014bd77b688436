"""Reads a snapshot with VTK's own reader and prints what it found, one `name value...` a line.

Usage: read_with_vtk.py FILE. Exit code 3 where the module is missing.
"""
import sys

try:
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError as error:
    print(f"VTK's reader is missing ({error}): apt-get install python3-vtk9", file=sys.stderr)
    sys.exit(3)

reader = vtkHDFReader()
if not reader.CanReadFile(sys.argv[1]):
    print("VTK says that it cannot read this file", file=sys.stderr)
    sys.exit(1)
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
print("class", grid.GetClassName())
print("points", grid.GetNumberOfPoints())
print("cells", grid.GetNumberOfCells())
for i in range(grid.GetNumberOfPoints()):
    print("point", i, *(value.hex() for value in grid.GetPoint(i)))
for i in range(grid.GetNumberOfCells()):
    print("cell", i, grid.GetCellType(i), grid.GetCell(i).GetPointId(0))
for owner, data in (("point_array", grid.GetPointData()), ("field_array", grid.GetFieldData())):
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        values = [array.GetTuple(j)[k] for j in range(array.GetNumberOfTuples())
                  for k in range(array.GetNumberOfComponents())]
        print(owner, array.GetName(), array.GetNumberOfComponents(), *(float(v).hex() for v in values))
